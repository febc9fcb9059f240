// What the response costs: 64 contacts of a pair, problem by problem, and islands of 10 to 3,000
// contacts, with and without a limit to the passes.
// SPDX-License-Identifier: MIT
#include <benchmark/benchmark.h>
#include <time.h>

#include <algorithm>
#include <string>
#include <vector>

#include "engine/dynamics/responder.hpp"
#include "tests/engine/response_scenes.hpp"

namespace impetus {
namespace {

double thread_time_us() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e6 * static_cast<double>(now.tv_sec) + 1e-3 * static_cast<double>(now.tv_nsec);
}

ResponseRules rules_of(const benchmark::State& state) {
  ResponseRules rules;
  rules.method = state.range(1) != 0 ? ResponseMethod::kTogether : ResponseMethod::kInTurn;
  rules.most_passes = state.range(2) != 0 ? static_cast<int>(state.range(2)) : kUnlimitedPasses;
  return rules;
}

std::string label_of(const benchmark::State& state) {
  const std::string passes = std::to_string(state.range(2));
  return std::string(state.range(1) != 0 ? "together" : "in turn") +
         (state.range(2) != 0 ? ", " + passes + " passes" : "");
}

/// One problem after the other of 10,000; their mean and 99th percentile are counters (µs, with the
/// clock's own time, about .3).
void response_to_a_pair(benchmark::State& state) {
  RandomStream random(2002, "pairs");
  std::vector<ResponseProblem> problems;
  for (int i = 0; i < 10'000; ++i) {
    problems.push_back(random_pair(random, static_cast<std::uint64_t>(state.range(0))));
  }
  const ResponseRules rules = rules_of(state);
  Responder responder;
  std::vector<double> times_us;
  for (auto unused : state) {
    times_us.clear();
    for (const ResponseProblem& problem : problems) {
      std::vector<BodyState> states = problem.states;
      const double start_us = thread_time_us();
      responder.respond(problem.contacts, problem.restitutions, rules, problem.models, states);
      times_us.push_back(thread_time_us() - start_us);
    }
  }
  std::sort(times_us.begin(), times_us.end());
  double sum_us = 0.0;
  for (const double time_us : times_us) {
    sum_us += time_us;
  }
  state.counters["mean_us"] = sum_us / static_cast<double>(times_us.size());
  state.counters["p99_us"] = times_us[times_us.size() * 99 / 100];
  state.SetLabel(label_of(state));
}
BENCHMARK(response_to_a_pair)
    ->ArgsProduct({{4, 16, 64}, {0, 1}, {0}})
    ->Unit(benchmark::kMillisecond);

/// Time per contact of one island: a heap of bodies at random, two contacts for each.
void response_to_an_island(benchmark::State& state) {
  RandomStream random(2002, "island");
  const auto bodies = static_cast<int>(std::max<std::int64_t>(2, state.range(0) / 2));
  const ResponseProblem heap = random_heap(random, bodies, /*points=*/3);
  const ResponseRules rules = rules_of(state);
  Responder responder;
  for (auto unused : state) {
    std::vector<BodyState> states = heap.states;
    benchmark::DoNotOptimize(
        responder.respond(heap.contacts, heap.restitutions, rules, heap.models, states));
  }
  state.SetLabel(label_of(state) + ", " + std::to_string(heap.contacts.size()) + " contacts");
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(heap.contacts.size()));
}
BENCHMARK(response_to_an_island)->ArgsProduct({{10, 100, 1'000, 3'000}, {0}, {0, 10}});
BENCHMARK(response_to_an_island)->ArgsProduct({{10, 100, 1'000, 3'000}, {1}, {10}});
BENCHMARK(response_to_an_island)->ArgsProduct({{10, 100, 300}, {1}, {0}});

}  // namespace
}  // namespace impetus
