// SPDX-License-Identifier: MIT
#include "tests/bench/crowd_scenes.hpp"

#include <array>
#include <cstdio>
#include <string>

#include "tests/bench/crowd_run.hpp"

namespace impetus {
namespace {

constexpr double kFill = 0.3;
constexpr int kHopelessSteps = 12;  ///< where a step takes half a second
constexpr int kStoppedSteps = 120;  ///< where fast bodies are followed along their way: slow

void print_head() {
  std::printf("  %-38s %8s %8s %8s  %6s %8s %9s  %7s %5s  %s\n", "", "median", "p99", "longest",
              "pairs", "contacts", "work", "energy", "outs", "");
}

/// What a user should worry about; empty when there is nothing.
std::string faults_of(const CrowdOutcome& outcome) {
  std::string text;
  const auto add = [&](int count, const char* what) {
    if (count > 0) {
      text += std::string(text.empty() ? "" : ", ") + std::to_string(count) + " " + what;
    }
  };
  add(outcome.overruns, "OVERRUNS");
  add(outcome.floors_over, "floors over budget");
  add(outcome.approaches_left, "steps left approaching");
  add(outcome.not_finite, "NOT FINITE");
  add(outcome.stopped, "stopped at entry");
  return text;
}

CrowdOutcome print_run(const std::string& name, const CrowdShape& shape,
                       const BenchCrowdStart& start, const CrowdPlan& plan, const char* goal) {
  const CrowdOutcome outcome = run_crowd(shape, start, plan);
  std::printf("  %-38s %8.3f %8.3f %8.3f  %6.0f %8.0f %9.0f  %7.4f %5d  %s%s%s\n", name.c_str(),
              outcome.step_ms.median, outcome.step_ms.p99, outcome.step_ms.longest,
              outcome.touching_pairs, outcome.contacts, outcome.tests, outcome.energy_ratio,
              outcome.escaped, faults_of(outcome).c_str(), *goal != 0 ? "  goal: " : "", goal);
  if (plan.budget_ms > 0.0) {
    std::printf("  %-38s longest step / budget %.3f; at the finest level of list 0: %.1f %%\n", "",
                outcome.step_ms.longest / plan.budget_ms,
                100.0 * static_cast<double>(outcome.urgent_finest) /
                    static_cast<double>(std::max<std::int64_t>(1, outcome.urgent)));
  }
  std::fflush(stdout);
  return outcome;
}

/// As many as other engines make by default, and some more.
constexpr int kFewPasses = 20;

std::string leaves_and_passes(bool fine, int most_passes) {
  std::string text = fine ? "~500 leaves" : "~64 leaves";
  if (most_passes != kUnlimitedPasses) {
    text += ", " + std::to_string(most_passes) + " passes";
  }
  return text;
}

void print_title(const std::string& title, const BenchCrowdStart& start) {
  std::printf("\n%s (ms", title.c_str());
  if (start.touching > 0) {
    std::printf("; %d bodies start in contact", start.touching);
  }
  std::printf(")\n");
  print_head();
}

}  // namespace

void print_cube(const CrowdShape& shape, const BenchOptions& options) {
  const BenchCrowdStart start = flying(shape, 250, kFill);
  print_title("250 bodies, closed cube, 30 % full, restitution .5", start);
  for (const bool fine : {false, true}) {
    CrowdPlan plan{fine, /*restitution=*/0.5};
    plan.steps = options.steps_of(plan.steps);
    const std::string leaves = fine ? "~500 leaves" : "~64 leaves";
    print_run(leaves, shape, start, plan, fine ? "median .8" : "median .25");
    plan.tunnelling = Tunnelling::kStopAtEntry;
    plan.steps = options.steps_of(kStoppedSteps);
    print_run(leaves + ", stopped at entry", shape, start, plan, "");
  }
}

void print_elastic(const CrowdShape& shape, const BenchOptions& options) {
  struct Filled {
    int bodies;
    double fill;
  };
  for (const auto [bodies, fill] : {Filled{250, kFill}, Filled{100, 1.5}}) {
    const BenchCrowdStart start = flying(shape, bodies, fill);
    print_title(std::to_string(bodies) + " bodies, closed cube, restitution 1, 5 s", start);
    for (const bool fine : {false, true}) {
      CrowdPlan plan{fine, /*restitution=*/1.0};
      plan.steps = options.steps_of(plan.steps);
      const std::string leaves = fine ? "~500 leaves" : "~64 leaves";
      print_run(leaves, shape, start, plan, "energy 1 ± .02, none outside");
      plan.tunnelling = Tunnelling::kStopAtEntry;
      plan.steps = options.steps_of(kStoppedSteps);
      print_run(leaves + ", stopped at entry", shape, start, plan, "");
    }
  }
}

void print_implosion(const CrowdShape& shape, const BenchOptions& options) {
  const BenchCrowdStart start = imploding(shape, 250);
  print_title("implosion of 250 bodies, restitution .5", start);
  for (const bool fine : {true, false}) {
    for (const double budget_ms : {0.0, 4.0, 1.0}) {
      CrowdPlan plan{fine, /*restitution=*/0.5, budget_ms};
      plan.steps = options.steps_of(360);
      std::string name = fine ? "~500 leaves, " : "~64 leaves, ";
      name += budget_ms > 0.0 ? "budget " + std::to_string(static_cast<int>(budget_ms)) + " ms"
                              : std::string("no budget");
      print_run(name, shape, start, plan,
                budget_ms > 0.0 ? "no overrun, longest ≤ 1.05 budget" : "");
    }
  }
  CrowdPlan stopping{/*fine=*/true, /*restitution=*/0.5, /*budget_ms=*/4.0};
  stopping.steps = options.steps_of(120);
  stopping.tunnelling = Tunnelling::kStopAtEntry;
  for (const std::int64_t most : {kUnlimitedTests, std::int64_t{100'000}}) {
    stopping.most_entry_tests = most;
    print_run(most == kUnlimitedTests ? "~500 leaves, 4 ms, stopped at entry"
                                      : "the same, 100,000 entry tests",
              shape, start, stopping, "");
  }
}

void print_thousand(const CrowdShape& shape, const BenchOptions& options) {
  const BenchCrowdStart start = flying(shape, 1000, 1.0);
  print_title(
      "1,000 bodies, closed cube, 100 % full, restitution .5, ~500 leaves; a tenth of pairs urgent",
      start);
  CrowdPlan plan{/*fine=*/true, /*restitution=*/0.5, /*budget_ms=*/4.0};
  plan.steps = options.steps_of(120);
  plan.schedule.rule = make_list_rule("pair_shares");
  plan.schedule.limits = {0.1};
  plan.schedule.lists = {{.share = 1.0}, {.share = 0.0}};
  plan.most_response_passes = kFewPasses;
  for (const int least_level : {0, 1, 2}) {
    plan.schedule.lists = {{.share = 1.0, .least_level = least_level},
                           {.share = 0.0, .least_level = least_level}};
    print_run(
        "4 ms, 20 passes, least level " + std::to_string(least_level), shape, start, plan,
        least_level == 0 ? "held; every pair at its coarsest level, list 0 at its finest" : "");
  }
  plan.schedule.lists = {{.share = 1.0}, {.share = 0.0}};
  plan.most_response_passes = kUnlimitedPasses;
  plan.steps = options.steps_of(kHopelessSteps);
  print_run("4 ms, all passes", shape, start, plan, "");
  plan.budget_ms = 0.0;
  plan.steps = options.steps_of(120);
  print_run("no budget, all passes", shape, start, plan, "");
}

void print_pit(const CrowdShape& shape, const BenchOptions& options) {
  const BenchCrowdStart start = falling(shape, 250);
  print_title("250 bodies piled in a pit under gravity, restitution .5; 5 s", start);
  for (const bool fine : {false, true}) {
    for (const int most_passes : {kUnlimitedPasses, kFewPasses}) {
      CrowdPlan plan{fine, /*restitution=*/0.5};
      plan.steps = options.steps_of(plan.steps);
      plan.most_response_passes = most_passes;
      const CrowdOutcome outcome =
          print_run(leaves_and_passes(fine, most_passes), shape, start, plan, fine ? "16" : "4");
      std::printf("  %-38s speed at the end %.3f m/s\n", "", outcome.speed_m_s);
    }
  }
}

void print_growth(const CrowdShape& shape, const BenchOptions& options) {
  constexpr std::array kCounts{10, 20, 50, 100, 200, 500, 1000, 2000, 10'000};
  for (const bool fine : {false, true}) {
    std::printf(
        "\ngrowth, closed cube, 30 %% full, ~%d leaves, restitution 1   goal: linear within 20 "
        "%%\n",
        fine ? 500 : 64);
    std::printf("  %8s %10s %12s %14s %14s %16s\n", "bodies", "ms", "us/body", "pairs/body",
                "work/body", "ns/unit of work");
    for (const int bodies : kCounts) {
      CrowdPlan plan{fine};
      plan.steps = options.steps_of(120);
      const CrowdOutcome outcome = run_crowd(shape, flying(shape, bodies, kFill), plan);
      std::printf("  %8d %10.4f %12.3f %14.3f %14.1f %16.2f\n", bodies, outcome.step_ms.median,
                  1e3 * outcome.step_ms.median / bodies, outcome.touching_pairs / bodies,
                  outcome.tests / bodies, 1e6 * outcome.step_ms.mean / outcome.tests);
      std::fflush(stdout);
    }
  }
}

}  // namespace impetus
