// SPDX-License-Identifier: MIT
#include "tests/bench/crowd_run.hpp"

#include <algorithm>
#include <cmath>

#include "engine/scheduling/deadline_work.hpp"

namespace impetus {
namespace {

/// Adds what one step reports.
void add_report(const StepReport& report, double step_share, CrowdOutcome& outcome) {
  outcome.touching_pairs += step_share * static_cast<double>(report.collisions.size());
  outcome.contacts += step_share * static_cast<double>(report.contacts.size());
  outcome.tests += step_share * static_cast<double>(report.work_spent);
  outcome.overruns += report.work_peak > std::max(report.work_granted, report.work_floor) ? 1 : 0;
  outcome.floors_over += (report.degradations & kFloorOverBudget) != 0 ? 1 : 0;
  outcome.approaches_left += (report.degradations & kApproachRemains) != 0 ? 1 : 0;
  outcome.not_finite += (report.degradations & kNotFinite) != 0 ? 1 : 0;
  outcome.stopped += static_cast<int>(report.stopped.size());
  for (const CollisionReport& collision : report.collisions) {
    outcome.urgent += collision.list == 0 ? 1 : 0;
    outcome.urgent_finest += collision.list == 0 && collision.stop == StopReason::kFinest ? 1 : 0;
  }
}

double root_mean_square_speed_m_s(const World& world) {
  double squares = 0.0;
  for (std::size_t body = 0; body < world.states().size(); ++body) {
    squares += velocity(world.models()[body], world.states()[body]).squaredNorm();
  }
  return std::sqrt(squares / static_cast<double>(world.states().size()));
}

}  // namespace

World crowd_world(const CrowdShape& shape, const BenchCrowdStart& start, const CrowdPlan& plan) {
  WorldSettings settings;
  settings.restitution = plan.restitution;
  settings.tunnelling = plan.tunnelling;
  settings.most_entry_tests = plan.most_entry_tests;
  settings.schedule = plan.schedule;
  settings.costs = kAllPhases;
  settings.gravity_m_s2 = start.gravity_m_s2;
  settings.most_response_passes = plan.most_response_passes;
  if (start.half_edge_m > 0.0) {
    settings.enclosure = ClosedCube{start.half_edge_m};
  }
  const BodyModel model = model_of(shape, plan.fine ? shape.fine : shape.coarse);
  return {std::vector<BodyModel>(start.states.size(), model), start.states, std::move(settings)};
}

StepInput crowd_input(const BenchCrowdStart& start) {
  StepInput input;
  input.dt_s = kCrowdStep_s;
  input.viewer.eye = Vector3(0.0, 0.0, std::max(40.0, 4.0 * start.half_edge_m));
  return input;
}

CrowdOutcome run_crowd(const CrowdShape& shape, const BenchCrowdStart& start,
                       const CrowdPlan& plan) {
  World world = crowd_world(shape, start, plan);
  const StepInput input = crowd_input(start);
  const ThreadCpuClock clock;
  DeadlineWork deadline(clock, static_cast<std::int64_t>(plan.budget_ms * 1e6));
  FixedWork unlimited(kUnlimitedTests);
  const bool limited = plan.budget_ms > 0.0;
  const double energy_before_J = kinetic_energy_of(world);
  CrowdOutcome outcome;
  std::vector<double> steps_ms;
  for (int step = 0; step < plan.steps; ++step) {
    const std::int64_t start_ns = thread_cpu_ns();
    if (limited) {
      deadline.start_step();
    }
    const StepReport& report =
        world.step(input, limited ? static_cast<WorkMeter&>(deadline) : unlimited);
    steps_ms.push_back(static_cast<double>(thread_cpu_ns() - start_ns) * 1e-6);
    add_report(report, 1.0 / plan.steps, outcome);
  }
  outcome.step_ms = spread_of(std::move(steps_ms));
  outcome.energy_ratio = energy_before_J > 0.0 ? kinetic_energy_of(world) / energy_before_J : 0.0;
  outcome.speed_m_s = root_mean_square_speed_m_s(world);
  outcome.escaped = escaped_from(start.half_edge_m, world.states());
  return outcome;
}

int escaped_from(double half_edge_m, const std::vector<BodyState>& states) {
  return static_cast<int>(std::count_if(states.begin(), states.end(), [&](const BodyState& state) {
    return half_edge_m > 0.0 && !(state.pose.position.cwiseAbs().maxCoeff() <= half_edge_m);
  }));
}

double kinetic_energy_of(const World& world) {
  double energy_J = 0.0;
  for (std::size_t body = 0; body < world.states().size(); ++body) {
    energy_J += kinetic_energy(world.models()[body], world.states()[body]);
  }
  return energy_J;
}

}  // namespace impetus
