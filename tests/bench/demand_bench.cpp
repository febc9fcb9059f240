// What scenes of growing demand pay, each beside the one before it.
//
//   impetus_demand_bench [--only SCENE] [--steps N] [--quick]
//
//   bytes     world: bodies, states and trees placed; trees; what steps work with, at the end
//   step      node-pair tests, nodes transformed, calls of `new` after the first second, all by
//             step; microseconds of thread CPU time: median, 99th percentile
//
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdio>
#include <exception>
#include <set>
#include <string>

#include "tests/bench/bench_options.hpp"
#include "tests/bench/thread_time.hpp"
#include "tests/engine/allocation/counted_new.hpp"
#include "tests/experiments/demand_scenes.hpp"
#include "tests/places/places.hpp"

namespace impetus {
namespace {

constexpr double kSeconds = 20.0;  ///< of a scene's own time
constexpr double kQuickSeconds = 3.0;
constexpr double kWarmUp_s = 1.0;  ///< in which a step may allocate

struct Demand {
  double world_kB{0.0};
  double trees_kB{0.0};
  double step_memory_kB{0.0};
  double tests{0.0};
  double nodes{0.0};
  double allocations{0.0};
  Spread step_us{};
  bool tests_are_exact{true};
};

double trees_kB(const World& world) {
  std::set<const VolumeTree*> trees;
  double bytes = 0.0;
  for (const BodyModel& body : world.models()) {
    if (trees.insert(body.tree.get()).second) {
      bytes += static_cast<double>(body.tree->bytes());
    }
  }
  return 1e-3 * bytes;
}

/// A world that starts anew at the end of each run of its scene, step after step.
class Run {
 public:
  explicit Run(const DemandScene& scene)
      : scene_(&scene), meter_(scene.staged.budget.tests_per_step), world_(scene.staged.world) {}

  /// Where the step is prepared, nothing of it is counted yet.
  StepInput prepare() {
    if (step_ == steps_of_a_run(*scene_)) {
      world_ = scene_->staged.world;
      step_ = 0;
    }
    return input_of_step(*scene_, ++step_);
  }
  const StepReport& step(const StepInput& input) { return world_.step(input, meter_); }
  World& world() { return world_; }

 private:
  const DemandScene* scene_;
  FixedWork meter_;
  World world_;
  std::int64_t step_{0};
};

/// Of the same steps, counted as tests alone: so long as both leave the same states.
void count_tests(const DemandScene& scene, std::int64_t steps, Demand& demand) {
  Run as_asked(scene);
  Run counted(scene);
  std::int64_t tests = 0;
  for (std::int64_t step = 0; step < steps; ++step) {
    const std::uint64_t hash = as_asked.step(as_asked.prepare()).state.hash;
    const StepInput input = counted.prepare();
    counted.world().set_costs({});
    const StepReport& report = counted.step(input);
    tests += report.work_spent;
    demand.tests_are_exact = demand.tests_are_exact && report.state.hash == hash;
  }
  demand.tests = static_cast<double>(tests) / static_cast<double>(steps);
}

Demand measured(const DemandScene& scene, std::int64_t steps, double looking_us) {
  Demand demand;
  const auto warm_up = static_cast<std::int64_t>(kWarmUp_s * scene.staged.step_hz);
  std::vector<double> samples;
  samples.reserve(static_cast<std::size_t>(steps));
  const std::int64_t before = allocated().bytes;
  Run run(scene);
  const std::int64_t stepless = allocated().bytes;
  const std::int64_t nodes_before = run.world().nodes_transformed();
  std::int64_t allocations = 0;
  std::int64_t transformed = 0;
  std::int64_t last_nodes = nodes_before;
  for (std::int64_t step = 0; step < steps; ++step) {
    const StepInput input = run.prepare();
    last_nodes = run.world().nodes_transformed();
    const std::int64_t calls = allocated().calls;
    const std::int64_t start_ns = thread_cpu_ns();
    run.step(input);
    samples.push_back(static_cast<double>(thread_cpu_ns() - start_ns) * 1e-3 - looking_us);
    allocations += step >= warm_up ? allocated().calls - calls : 0;
    transformed += run.world().nodes_transformed() - last_nodes;
  }
  demand.world_kB =
      1e-3 * static_cast<double>(stepless - before + static_cast<std::int64_t>(sizeof(World)));
  demand.trees_kB = trees_kB(run.world());
  demand.step_memory_kB = 1e-3 * static_cast<double>(allocated().bytes - stepless);
  demand.nodes = static_cast<double>(transformed) / static_cast<double>(steps);
  demand.allocations = static_cast<double>(allocations) /
                       static_cast<double>(std::max<std::int64_t>(1, steps - warm_up));
  demand.step_us = spread_of(std::move(samples));
  count_tests(scene, steps, demand);
  return demand;
}

/// How many times what the scene before pays, "" for the first.
std::string times(double now, double before) {
  char text[32] = "";
  if (before > 0.0) {
    std::snprintf(text, sizeof text, " (x %.3g)", now / before);
  }
  return text;
}

void print(const std::string& name, const Demand& demand, const Demand& before) {
  const auto cell = [](double value, const std::string& beside) {
    char text[64];
    std::snprintf(text, sizeof text, "%.3g%s", value, beside.c_str());
    return std::string(text);
  };
  std::printf(
      "%-22s | %-17s | %-15s | %-15s | %s%-17s | %-17s | %-8s | %-15s | %-15s\n", name.c_str(),
      cell(demand.world_kB, times(demand.world_kB, before.world_kB)).c_str(),
      cell(demand.trees_kB, times(demand.trees_kB, before.trees_kB)).c_str(),
      cell(demand.step_memory_kB, times(demand.step_memory_kB, before.step_memory_kB)).c_str(),
      demand.tests_are_exact ? "" : "about ",
      cell(demand.tests, times(demand.tests, before.tests)).c_str(),
      cell(demand.nodes, times(demand.nodes, before.nodes)).c_str(),
      cell(demand.allocations, "").c_str(),
      cell(demand.step_us.median, times(demand.step_us.median, before.step_us.median)).c_str(),
      cell(demand.step_us.p99, times(demand.step_us.p99, before.step_us.p99)).c_str());
  std::fflush(stdout);
}

void print_asked(const BenchOptions& options) {
  ShapeLibrary library;
  Demand before;
  const double looking_us = 1e-3 * clock_cost_ns();
  std::printf("a look at the clock took %.2f us, which is taken off\n", looking_us);
  std::printf("%-22s | %-17s | %-15s | %-15s | %-17s | %-17s | %-8s | %-15s | %-15s\n", "scene",
              "world, kB", "trees, kB", "step memory, kB", "tests", "nodes transformed", "new",
              "us, median", "us, p99");
  const auto stimuli = std::filesystem::path(source_folder()) / "stimuli";
  for (const DemandScene& scene : scenes_of_growing_demand(stimuli, library)) {
    if (options.asks_for(scene.name)) {
      const double seconds = options.quick ? kQuickSeconds : kSeconds;
      const auto steps = static_cast<int>(seconds * scene.staged.step_hz);
      const Demand demand = measured(scene, options.steps.value_or(steps), looking_us);
      print(scene.name, demand, before);
      before = demand;
    }
  }
}

}  // namespace
}  // namespace impetus

int main(int count, char** arguments) {
  try {
    impetus::print_asked(impetus::bench_options(count, arguments));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
  return 0;
}
