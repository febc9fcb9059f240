// SPDX-License-Identifier: MIT
#include "tests/bench/small_scenes.hpp"

#include <cstdio>

#include "engine/dynamics/state_hash.hpp"
#include "tests/bench/crowd_run.hpp"
#include "tests/bench/response_cost.hpp"

namespace impetus {
namespace {

constexpr int kBatch = 1'000;
constexpr int kBatches = 31;
constexpr int kProblems = 10'000;

/// Two balls of radius 1 m that fly apart, or rest in contact.
World two_balls(bool in_contact) {
  const Sphere sphere{{0.0, 0.0, 0.0}, 1.0};
  const MassProperties mass = solid_sphere(sphere.radius_m, kSolidDensity_kg_m3);
  BodyModel ball;
  ball.tree = std::make_shared<VolumeTree>(single_node_tree(sphere));
  ball.inverse_mass = 1.0 / mass.mass_kg;
  ball.inverse_inertia = mass.inertia.inverse();
  BodyState left;
  BodyState right;
  right.pose.position.x() = in_contact ? 1.99 : 4.0;
  if (!in_contact) {
    right.linear_momentum.x() = mass.mass_kg * 0.1;
  }
  return {{ball, ball}, {left, right}, {}};
}

/// Microseconds of a step, by batches.
Spread step_us(World world, int batches) {
  StepInput input;
  input.dt_s = kCrowdStep_s;
  FixedWork unlimited(kUnlimitedTests);
  std::vector<double> samples;
  for (int batch = 0; batch < batches; ++batch) {
    const std::int64_t start_ns = thread_cpu_ns();
    for (int step = 0; step < kBatch; ++step) {
      static_cast<void>(world.step(input, unlimited));
    }
    samples.push_back(static_cast<double>(thread_cpu_ns() - start_ns) * 1e-3 / kBatch);
  }
  return spread_of(std::move(samples));
}

void print_method(const char* name, ResponseMethod method, const CrowdShape& shape, int problems) {
  const ResponseCost cost = response_cost(shape, method, problems);
  std::printf("  %-10s %8.2f us mean, %.2f median, %.2f p99, %.2f longest; %d left approaching\n",
              name, cost.us.mean, cost.us.median, cost.us.p99, cost.us.longest,
              cost.left_approaching);
}

}  // namespace

void print_spheres(const CrowdShape& /*shape*/, const BenchOptions& options) {
  std::printf("\ntwo spheres, one step   goal: 1 us\n");
  for (const bool in_contact : {false, true}) {
    const Spread us = step_us(two_balls(in_contact), options.count_of(kBatches));
    std::printf("  %-10s %8.3f us median of batches\n", in_contact ? "touching" : "apart",
                us.median);
  }
}

void print_response(const CrowdShape& shape, const BenchOptions& options) {
  std::printf("\nresponse to 64 contacts of one pair, restitution .5   goal: 5 us mean, 12 p99\n");
  print_method("in turn", ResponseMethod::kInTurn, shape, options.count_of(kProblems));
  print_method("together", ResponseMethod::kTogether, shape, options.count_of(kProblems));
}

void print_hash(const CrowdShape& shape, const BenchOptions& options) {
  CrowdPlan plan;
  plan.steps = options.steps_of(600);
  const BenchCrowdStart start = flying(shape, 15, 0.3);
  const CrowdOutcome outcome = run_crowd(shape, start, plan);
  std::int64_t bits = 0;
  const std::int64_t start_ns = thread_cpu_ns();
  for (int i = 0; i < kBatch; ++i) {
    bits ^= static_cast<std::int64_t>(hash_state(start.states).hash);
  }
  const double hash_us = static_cast<double>(thread_cpu_ns() - start_ns) * 1e-3 / kBatch;
  const double step_mean_us = 1e3 * outcome.step_ms.mean;
  std::printf("\nhash of a step of 15 bodies, ~500 leaves, 30 %% full   goal: 1 %% with the log\n");
  std::printf("  hash %.3f us of %.1f us (mean): %.2f %%%s\n", hash_us, step_mean_us,
              100.0 * hash_us / step_mean_us, bits == 1 ? " " : "");
}

}  // namespace impetus
