// Twenty humanoids in a closed cube: what a step costs at each level, and with a budget of 4 ms.
//
//   impetus_figures_bench [--steps N] [--quick]
//
// Thread CPU time. "without hinges" are the same 320 parts, each a body by itself: what figures
// add.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdio>
#include <exception>
#include <string>
#include <utility>

#include "engine/scheduling/deadline_work.hpp"
#include "experiments/files/scene_files.hpp"
#include "experiments/protocol/screen_file.hpp"
#include "experiments/scenes/scene_file.hpp"
#include "experiments/scenes/shape_library.hpp"
#include "tests/bench/bench_options.hpp"
#include "tests/bench/thread_time.hpp"
#include "tests/places/places.hpp"

namespace impetus {
namespace {

constexpr int kSteps = 1200;
constexpr int kMostLevel = 3;
constexpr std::int64_t kBudget_ns = 4'000'000;

struct Measured {
  Spread ms;
  double contacts{0.0};     ///< a step
  double collisions{0.0};   ///< a step
  double units{0.0};        ///< spent, a step
  int overruns{0};          ///< steps that spent more than was granted, or than the floor
  int over_budget{0};       ///< steps that took longer than the budget
  double hinge_gap_m{0.0};  ///< the widest
};

StagedScene staged_humanoids() {
  ShapeLibrary library;
  const JsonDocument scene = load_scene(source_folder() + "/stimuli/humanoids-in-a-cube.json");
  return build_scene(scene.value, assumed_screen(), 0.0, library);
}

/// The scene's world with one list that goes no deeper than a level, or as it is.
World world_of(const StagedScene& scene, int greatest_level, bool hinged) {
  WorldSettings settings = scene.world.settings();
  if (greatest_level >= 0) {
    settings.schedule = Schedule{};
    settings.schedule.lists[0].greatest_level = greatest_level;
  }
  if (!hinged) {
    settings.figures.clear();
  }
  return World(scene.world.models(), scene.world.states(), settings);
}

double widest_gap_m(const World& world) {
  double widest = 0.0;
  for (const Figure& figure : world.settings().figures) {
    for (const Hinge& hinge : figure.hinges) {
      widest = std::max(
          widest, anchor_gap_m(hinge, world.states()[static_cast<std::size_t>(hinge.child)].pose,
                               world.states()[static_cast<std::size_t>(hinge.parent)].pose));
    }
  }
  return widest;
}

template <typename Prepare>
Measured measure(World world, const StagedScene& scene, int steps, WorkMeter& meter,
                 const Prepare& prepare) {
  const StepInput input{1.0 / scene.step_hz, scene.viewer};
  const double clock_ns = clock_cost_ns();
  std::vector<double> samples;
  Measured measured;
  for (int step = 0; step < steps; ++step) {
    prepare();
    const auto begin = thread_cpu_ns();
    const StepReport& report = world.step(input, meter);
    const double ns = static_cast<double>(thread_cpu_ns() - begin) - clock_ns;
    samples.push_back(1e-6 * ns);
    measured.contacts += static_cast<double>(report.contacts.size()) / steps;
    measured.collisions += static_cast<double>(report.collisions.size()) / steps;
    measured.units += static_cast<double>(report.work_spent) / steps;
    measured.overruns +=
        report.work_peak > std::max(report.work_granted, report.work_floor) ? 1 : 0;
    measured.over_budget += ns > static_cast<double>(kBudget_ns) ? 1 : 0;
    measured.hinge_gap_m = std::max(measured.hinge_gap_m, widest_gap_m(world));
  }
  measured.ms = spread_of(std::move(samples));
  return measured;
}

void print(const char* name, const Measured& measured, const Measured& coarsest) {
  std::printf("%-24s %7.2f %7.2f %7.2f %8.2f %9.1f %9.1f %10.0f %9d %9d %9.1e\n", name,
              measured.ms.median, measured.ms.p99, measured.ms.longest,
              measured.ms.median / coarsest.ms.median, measured.collisions, measured.contacts,
              measured.units, measured.overruns, measured.over_budget, measured.hinge_gap_m);
}

void print_bench(const BenchOptions& options) {
  const StagedScene scene = staged_humanoids();
  const int steps = options.steps_of(kSteps);
  std::printf("%zu figures, %zu parts, %d steps of %g Hz\n", scene.world.settings().figures.size(),
              scene.world.models().size(), steps, scene.step_hz);
  std::printf("%-24s %7s %7s %7s %8s %9s %9s %10s %9s %9s %9s\n", "", "ms", "p99", "longest",
              ": level 0", "collis.", "contacts", "units", "overruns", "> 4 ms", "gap, m");
  FixedWork unlimited(kUnlimitedTests);
  const auto nothing = [] {};
  Measured coarsest;
  for (int level = 0; level <= kMostLevel; ++level) {
    const Measured at_level =
        measure(world_of(scene, level, /*hinged=*/true), scene, steps, unlimited, nothing);
    if (level == 0) {
      coarsest = at_level;
    }
    print(("level " + std::to_string(level)).c_str(), at_level, coarsest);
  }
  print("level 0, without hinges",
        measure(world_of(scene, 0, /*hinged=*/false), scene, steps, unlimited, nothing), coarsest);
  const ThreadCpuClock clock;
  DeadlineWork deadline(clock, kBudget_ns);
  print("4 ms, as the scene says",
        measure(world_of(scene, -1, /*hinged=*/true), scene, steps, deadline,
                [&] { deadline.start_step(); }),
        coarsest);
}

}  // namespace
}  // namespace impetus

int main(int count, char** arguments) {
  try {
    impetus::print_bench(impetus::bench_options(count, arguments));
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
