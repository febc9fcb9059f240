// Whether a budget holds: the longest step of scenes with a budget in milliseconds, out of the box.
//
//   impetus_budget_bench [--only SCENE] [--steps N] [--quick] [MESH]
//
//   free      longest step without a budget (ms of thread CPU time)
//   1, 4, 16  longest step under that budget, and over it; what a step may take beyond is the
//             greater of .05 ms and 2 %
//   floor     longest step of which nothing is granted: a budget below it cannot hold
//   energy    of the end over the start, the most of all runs
//   outside   the most bodies whose centre is beyond a wall at any time
//   overruns  in work, of all runs
//
// Longest steps are medians of five runs. Scenes are all of the project's files with their own
// settings, crowds of creatures in their cube, and the crowds of the other benchmarks, whose body
// is the MESH.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/scheduling/deadline_work.hpp"
#include "experiments/files/scene_files.hpp"
#include "experiments/protocol/screen_file.hpp"
#include "experiments/scenes/scene_file.hpp"
#include "tests/bench/bench_options.hpp"
#include "tests/bench/crowd_run.hpp"
#include "tests/places/places.hpp"

namespace impetus {
namespace {

constexpr int kRuns = 5;
constexpr std::array kBudgets_ms{1.0, 4.0, 16.0};

/// A world at its start, and what each of its steps is told.
struct BudgetScene {
  std::string name;
  std::function<World()> start;
  StepInput input;
  int steps;
};

/// What one run showed.
struct BudgetRun {
  double longest_ms{0.0};
  double energy_ratio{0.0};
  int outside{0};
  int overruns{0};
};

int bodies_outside(const World& world) {
  if (!world.settings().enclosure) {
    return 0;
  }
  int count = 0;
  for (const BodyState& state : world.states()) {
    bool outside = false;
    for (int wall = 0; wall < kWallCount; ++wall) {
      outside = outside || reach_beyond(*world.settings().enclosure, wall,
                                        Sphere{state.pose.position, 0.0}) > 1e-9;
    }
    count += outside ? 1 : 0;
  }
  return count;
}

/// Kinetic, and of place where there is gravity (J).
double energy_of(const World& world) {
  double energy_J = kinetic_energy_of(world);
  for (std::size_t body = 0; body < world.states().size(); ++body) {
    const BodyModel& model = world.models()[body];
    if (model.inverse_mass > 0.0) {
      energy_J -= world.settings().gravity_m_s2.dot(world.states()[body].pose.position) /
                  model.inverse_mass;
    }
  }
  return energy_J;
}

template <typename Prepare>
BudgetRun run_scene(const BudgetScene& scene, WorkMeter& meter, const Prepare& prepare) {
  World world = scene.start();
  const double start_J = energy_of(world);
  BudgetRun run;
  for (int step = 0; step < scene.steps; ++step) {
    const std::int64_t began_ns = thread_cpu_ns();
    prepare();
    const StepReport& report = world.step(scene.input, meter);
    run.longest_ms =
        std::max(run.longest_ms, 1e-6 * static_cast<double>(thread_cpu_ns() - began_ns));
    run.overruns += report.work_peak > std::max(report.work_granted, report.work_floor) ? 1 : 0;
    run.outside = std::max(run.outside, bodies_outside(world));
    const double moved_J = energy_of(world) - start_J;
    const double scale_J = std::max(kinetic_energy_of(world), std::abs(start_J));
    run.energy_ratio = std::max(run.energy_ratio, scale_J > 0.0 ? moved_J / scale_J : 0.0);
  }
  return run;
}

BudgetRun run_under(const BudgetScene& scene, double budget_ms) {
  const ThreadCpuClock clock;
  DeadlineWork deadline(clock, static_cast<std::int64_t>(1e6 * budget_ms));
  return run_scene(scene, deadline, [&] { deadline.start_step(); });
}

BudgetRun run_granted(const BudgetScene& scene, const WorkGrants& grants) {
  FixedWork meter(grants);
  return run_scene(scene, meter, [] {});
}

/// The median of the longest steps, and the worst of all else.
BudgetRun summary_of(std::vector<BudgetRun> runs) {
  std::sort(runs.begin(), runs.end(),
            [](const BudgetRun& x, const BudgetRun& y) { return x.longest_ms < y.longest_ms; });
  BudgetRun summary = runs[runs.size() / 2];
  for (const BudgetRun& run : runs) {
    summary.energy_ratio = std::max(summary.energy_ratio, run.energy_ratio);
    summary.outside = std::max(summary.outside, run.outside);
    summary.overruns += &run == &runs[runs.size() / 2] ? 0 : run.overruns;
  }
  return summary;
}

void print_scene(const BudgetScene& scene, int runs) {
  std::vector<BudgetRun> all;
  const auto repeat = [&](const auto& run_once) {
    std::vector<BudgetRun> found;
    for (int run = 0; run < runs; ++run) {
      found.push_back(run_once());
      all.push_back(found.back());
    }
    return summary_of(std::move(found)).longest_ms;
  };
  WorkGrants nothing;
  nothing.units.fill(0);
  const double free_ms = repeat([&] { return run_granted(scene, WorkGrants{}); });
  const double floor_ms = repeat([&] { return run_granted(scene, nothing); });
  std::printf("%-34s %8.2f %8.2f ", scene.name.c_str(), free_ms, floor_ms);
  for (const double budget_ms : kBudgets_ms) {
    const double longest_ms = repeat([&] { return run_under(scene, budget_ms); });
    const double allowed_ms = budget_ms + std::max(0.05, 0.02 * budget_ms);
    std::printf(" %7.2f %5.2f%s", longest_ms, longest_ms / budget_ms,
                longest_ms <= allowed_ms ? "  " : " !");
    std::fflush(stdout);
  }
  const BudgetRun worst = summary_of(all);
  std::printf("  %8.1e %4d %4d\n", worst.energy_ratio, worst.outside, worst.overruns);
  std::fflush(stdout);
}

/// Every scene of stimuli/, without its ending; the other files there are schemas and a figure.
std::vector<std::string> shipped_scenes() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(source_folder() + "/stimuli")) {
    if (entry.path().extension() == ".json" && read_json(entry.path()).value.contains("engine")) {
      names.push_back(entry.path().stem().string());
    }
  }
  std::sort(names.begin(), names.end());
  return names;
}

BudgetScene staged(std::string name, const nlohmann::json& scene, int steps) {
  ShapeLibrary library;
  const StagedScene staged = build_scene(scene, assumed_screen(), kUnroundedHold, library);
  return {std::move(name), [world = staged.world] { return world; },
          StepInput{1.0 / staged.step_hz, staged.viewer}, steps};
}

nlohmann::json creatures(int count, double speed_deg_s) {
  nlohmann::json scene = load_scene(source_folder() + "/stimuli/creatures-in-a-cube.json").value;
  scene["crowd"]["count"] = count;
  scene["crowd"]["speed_deg_s"] = speed_deg_s;
  return scene;
}

nlohmann::json falling_creatures() {
  nlohmann::json scene = creatures(250, 15.0);
  scene["engine"]["gravity_m_s2"] = {0.0, -9.81, 0.0};
  scene["engine"]["restitution"] = 0.5;
  return scene;
}

BudgetScene crowd(std::string name, const CrowdShape& shape, const BenchCrowdStart& start,
                  int steps) {
  CrowdPlan plan{/*fine=*/true, /*restitution=*/0.5};
  plan.tunnelling = Tunnelling::kStopAtEntry;
  return {std::move(name), [&shape, start, plan] { return crowd_world(shape, start, plan); },
          crowd_input(start), steps};
}

void print_bench(const BenchOptions& options) {
  const CrowdShape shape = crowd_shape(options.mesh);
  const int steps = options.steps_of(300);
  const int runs = options.count_of(kRuns);
  std::printf("%-34s %8s %8s  %14s  %14s  %14s  %8s %4s %4s\n", "longest step, ms", "free", "floor",
              "1 ms", "4 ms", "16 ms", "energy +", "outs", "over");
  const auto print = [&](const std::string& name, const std::function<BudgetScene()>& make) {
    if (options.asks_for(name)) {
      BudgetScene scene = make();
      scene.name = name;
      print_scene(scene, runs);
    }
  };
  for (const std::string& file : shipped_scenes()) {
    print(file, [&] {
      return staged(file, load_scene(source_folder() + "/stimuli/" + file + ".json").value, steps);
    });
  }
  for (const double speed_deg_s : {15.0, 30.0, 60.0}) {
    print("creatures at " + std::to_string(static_cast<int>(speed_deg_s)) + " deg/s",
          [&] { return staged("", creatures(250, speed_deg_s), steps); });
  }
  print("creatures that fall", [&] { return staged("", falling_creatures(), steps); });
  for (const int count : {1000, 2000}) {
    print(std::to_string(count) + " creatures",
          [&] { return staged("", creatures(count, 15.0), steps / 2); });
  }
  for (const int count : {250, 1000}) {
    print("implosion of " + std::to_string(count),
          [&] { return crowd("", shape, imploding(shape, count), steps / 2); });
  }
  print("cube, 60 % full", [&] { return crowd("", shape, flying(shape, 250, 0.6), steps / 2); });
  print("cube, 150 % full", [&] { return crowd("", shape, flying(shape, 250, 1.5), steps / 2); });
  print("pit", [&] { return crowd("", shape, falling(shape, 250), steps); });
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
