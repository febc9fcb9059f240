// Steps per second: what the smallest scene pays, and a cube of blocks finely and coarsely handled.
// SPDX-License-Identifier: MIT
#include <benchmark/benchmark.h>

#include "experiments/files/protocol_files.hpp"
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

/// Ten seconds of the gaze-contingent study's fullest cube, as often as it takes.
void step_fifteen_blocks(benchmark::State& state, const char* kind) {
  const Protocol protocol = load_protocol(source_file("protocols/gaze-contingent.json"));
  const ProtocolScenes scenes(protocol, 0.0);
  const Condition cell{{"scheduling", std::string(kind)}, {"bodies", 15.0}};
  const StagedScene scene = scenes.stage(cell, assumed_screen());
  StepInput input{1.0 / scene.step_hz, scene.viewer};
  if (scene.region.kind == RegionKind::kAllGood) {
    input.region = GazeRegion{{}, 180.0};
  }
  FixedWork unlimited(kUnlimitedTests);
  World world = scene.world;
  std::int64_t step = 0;
  std::int64_t tests = 0;
  for (auto unused : state) {
    if (++step % 2400 == 0) {
      world = scene.world;
    }
    tests += world.step(input, unlimited).work_spent;
  }
  state.SetItemsProcessed(state.iterations());
  state.counters["times_real_time"] = benchmark::Counter(
      static_cast<double>(state.iterations()) / scene.step_hz, benchmark::Counter::kIsRate);
  state.counters["tests_per_step"] =
      static_cast<double>(tests) / static_cast<double>(state.iterations());
}
BENCHMARK_CAPTURE(step_fifteen_blocks, all_good, "all-good");
BENCHMARK_CAPTURE(step_fifteen_blocks, all_bad, "all-bad");

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
