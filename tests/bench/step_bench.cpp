// Steps per second of two spheres: what the smallest scene pays.
// SPDX-License-Identifier: MIT
#include <benchmark/benchmark.h>

#include "tests/experiments/fakes.hpp"

namespace impetus {
namespace {

void step_two_spheres(benchmark::State& state) {
  const Protocol protocol = causality();
  const ProtocolScenes scenes(protocol, 0.0);
  const Condition cell = cells(protocol.design).front();
  const StagedScene scene = scenes.stage(cell, assumed_screen());
  const StepInput input{1.0 / scene.step_hz, scene.viewer};
  FixedWork unlimited(kUnlimitedTests);
  World world = scene.world;
  std::int64_t step = 0;
  for (auto unused : state) {
    if (++step % 480 == 0) {
      world = scene.world;
    }
    benchmark::DoNotOptimize(world.step(input, unlimited));
  }
  state.SetItemsProcessed(state.iterations());
  state.counters["times_real_time"] = benchmark::Counter(
      static_cast<double>(state.iterations()) / scene.step_hz, benchmark::Counter::kIsRate);
}
BENCHMARK(step_two_spheres);

void hash_two_spheres(benchmark::State& state) {
  const std::vector<BodyState> states(2);
  for (auto unused : state) {
    benchmark::DoNotOptimize(hash_state(states));
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(hash_two_spheres);

}  // namespace
}  // namespace impetus
