// Candidate pairs of a drifting crowd, by sweep and prune and by all pairs.
// SPDX-License-Identifier: MIT
#include <benchmark/benchmark.h>

#include <cmath>

#include "engine/collision/broad_phase.hpp"
#include "tests/engine/builders.hpp"

namespace impetus {
namespace {

/// Balls that fill a twentieth of their cube, each moving by a hundredth of its radius a step.
class Crowd {
 public:
  explicit Crowd(std::int64_t count) : random_(9, "crowd") {
    for (std::int64_t i = 0; i < count; ++i) {
      bounds_.push_back({{random_in_cube(random_, 1.0), radius_m(count)}, 0.01 * radius_m(count)});
    }
  }

  const std::vector<MovedBound>& next() {
    for (MovedBound& bound : bounds_) {
      bound.bound.centre += random_in_cube(random_, bound.travelled_m);
    }
    return bounds_;
  }

 private:
  static double radius_m(std::int64_t count) {
    return std::cbrt(0.05 * 8.0 * 0.75 / 3.14159 / static_cast<double>(count));
  }

  RandomStream random_;
  std::vector<MovedBound> bounds_;
};

void pairs_by_sweep(benchmark::State& state) {
  Crowd crowd(state.range(0));
  SweepAndPrune sweep;
  std::size_t pairs = 0;
  for (auto unused : state) {
    pairs = sweep.candidates(crowd.next()).size();
    benchmark::DoNotOptimize(pairs);
  }
  state.counters["pairs"] = static_cast<double>(pairs);
}
BENCHMARK(pairs_by_sweep)->Arg(2)->Arg(15)->Arg(250)->Arg(1'000)->Arg(4'000);

void pairs_by_all_pairs(benchmark::State& state) {
  Crowd crowd(state.range(0));
  std::size_t pairs = 0;
  for (auto unused : state) {
    pairs = candidate_pairs(crowd.next()).size();
    benchmark::DoNotOptimize(pairs);
  }
  state.counters["pairs"] = static_cast<double>(pairs);
}
BENCHMARK(pairs_by_all_pairs)->Arg(2)->Arg(15)->Arg(250)->Arg(1'000)->Arg(4'000);

}  // namespace
}  // namespace impetus
