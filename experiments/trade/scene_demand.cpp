// SPDX-License-Identifier: MIT
#include "experiments/trade/scene_demand.hpp"

#include <algorithm>
#include <cmath>

#include "engine/numerics/at.hpp"
#include "experiments/run/scene_run.hpp"

namespace impetus::inline trade {
namespace {

constexpr std::int64_t kMostSteps = 2'400;
constexpr std::int64_t kMostProbes = 400;

std::int64_t pairs_in(const StepReport& report) {
  return std::count_if(report.collisions.begin(), report.collisions.end(),
                       [](const CollisionReport& each) { return !is_wall(each.bodies.b); });
}

/// How many pairs the next step begins to refine.
std::int64_t pairs_to_refine(SceneRun probe) {
  Schedule coarsest;
  coarsest.lists = {{1.0, 0, 0}};
  probe.world().set_schedule(coarsest);
  FixedWork meter(kUnlimitedTests);
  return pairs_in(probe.step({}, {}, meter));
}

MeetingMotion motion_of(const std::vector<BodyModel>& models, const std::vector<BodyState>& states,
                        const BodyPair& bodies) {
  const std::size_t a = at(bodies.a);
  const std::size_t b = at(bodies.b);
  return {(velocity(models[a], states[a]) - velocity(models[b], states[b])).norm(),
          angular_velocity(models[a], states[a]).norm(),
          angular_velocity(models[b], states[b]).norm()};
}

void note_meetings(const StepReport& report, const SceneRun& run, SceneDemand& demand) {
  for (const CollisionReport& each : report.collisions) {
    if (each.began && !is_wall(each.bodies.b)) {
      const MeetingMotion motion = motion_of(run.world().models(), run.before(), each.bodies);
      if (motion.approach_m_s > 0.0) {
        demand.meetings.push_back({at(each.bodies.a), at(each.bodies.b), motion});
      }
    }
  }
}

}  // namespace

SceneDemand demand_of(const StagedScene& scene, const Progress& progress) {
  SceneDemand demand;
  demand.steps =
      std::min(kMostSteps, static_cast<std::int64_t>(std::ceil(scene.duration_s * scene.step_hz)));
  const std::int64_t stride = (demand.steps + kMostProbes - 1) / kMostProbes;
  SceneRun run(scene);
  run.world().set_schedule({});
  FixedWork meter(kUnlimitedTests);
  for (std::int64_t step = 0; step < demand.steps; ++step) {
    if (step % stride == 0) {
      const std::int64_t pairs = pairs_to_refine(run);
      if (pairs > 0) {
        demand.pairs.push_back(static_cast<double>(pairs));
      }
    }
    const StepReport& report = run.step({}, {}, meter);
    note_meetings(report, run, demand);
    demand.touching_most = std::max(demand.touching_most, pairs_in(report));
    if (progress) {
      progress(static_cast<double>(step + 1) / static_cast<double>(demand.steps));
    }
  }
  return demand;
}

}  // namespace impetus::inline trade
