// Time for one overlap test and one contact, for every pair of kinds, of volumes about as far
// apart as in a descent: some overlap, some do not.
// SPDX-License-Identifier: MIT
#include <benchmark/benchmark.h>

#include "tests/engine/random_volumes.hpp"

namespace impetus {
namespace {

struct Pairs {
  std::vector<Volume> a;
  std::vector<Volume> b;
};

Pairs pairs_of(const benchmark::State& state) {
  RandomStream random(7, "pairs");
  Pairs pairs;
  for (int i = 0; i < 256; ++i) {
    pairs.a.push_back(
        random_volume(random, static_cast<int>(state.range(0)), random_in_cube(random, 0.7)));
    pairs.b.push_back(
        random_volume(random, static_cast<int>(state.range(1)), random_in_cube(random, 0.7)));
  }
  return pairs;
}

template <typename Procedure>
void run(benchmark::State& state, const Procedure& procedure) {
  const Pairs pairs = pairs_of(state);
  std::size_t i = 0;
  for (auto unused : state) {
    i = (i + 1) % pairs.a.size();
    benchmark::DoNotOptimize(procedure(pairs.a[i], pairs.b[i]));
  }
  state.SetLabel(std::string(kKindNames[static_cast<std::size_t>(state.range(0))]) + " and " +
                 kKindNames[static_cast<std::size_t>(state.range(1))]);
}

void every_pair(benchmark::internal::Benchmark* bench) {
  for (int a = 0; a < kKinds; ++a) {
    for (int b = a; b < kKinds; ++b) {
      bench->Args({a, b});
    }
  }
}

void overlap_of_pair(benchmark::State& state) {
  run(state, [](const Volume& a, const Volume& b) { return overlap(a, b); });
}
BENCHMARK(overlap_of_pair)->Apply(every_pair);

void contact_of_pair(benchmark::State& state) {
  run(state,
      [](const Volume& a, const Volume& b) { return touch(a, b, Vector3(Vector3::UnitX())); });
}
BENCHMARK(contact_of_pair)->Apply(every_pair);

}  // namespace
}  // namespace impetus
