// SPDX-License-Identifier: MIT
#include "experiments/observers/imagining/imagined_runs.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/numerics/elementary_functions.hpp"
#include "experiments/observers/draws.hpp"
#include "experiments/run/frame_poses.hpp"
#include "experiments/run/touching.hpp"

namespace impetus::inline observers {
namespace {

/// The bodies at these states but for one, and where the goal's body is among them.
struct Rest {
  World world;
  std::size_t body;
};

Rest rest_of(const StagedScene& scene, const std::vector<BodyState>& states,
             std::optional<std::size_t> without) {
  std::vector<BodyModel> models = scene.world.models();
  std::vector<BodyState> left = states;
  std::size_t body = scene.goal->body;
  if (without) {
    const auto place = static_cast<std::ptrdiff_t>(*without);
    models.erase(models.begin() + place);
    left.erase(left.begin() + place);
    body -= *without < body ? 1 : 0;
  }
  return {World(std::move(models), std::move(left), scene.world.settings()), body};
}

/// Steps worlds until something happens, or their time is over.
class Course {
 public:
  Course(const Viewer& viewer, double step_hz, std::int64_t tests) : meter_(tests) {
    input_.dt_s = 1.0 / step_hz;
    input_.viewer = viewer;
  }

  /// `before_step` may change the world; `has_happened` is asked after each step.
  template <typename BeforeStep, typename HasHappened>
  bool leads_to(const HasHappened& has_happened, World& world, std::int64_t steps,
                const BeforeStep& before_step) {
    for (std::int64_t step = 0; step < steps; ++step) {
      before_step(world);
      if (has_happened(world, world.step(input_, meter_))) {
        return true;
      }
    }
    return false;
  }

 private:
  StepInput input_;
  FixedWork meter_;
};

/// Whether the body is through.
auto passage_of(const Goal& goal, std::size_t body) {
  return [&goal, body](const World& world, const StepReport& /*of_step*/) {
    return goal.is_passed_at(world.states()[body].pose.position);
  };
}

/// No list of the schedule refines deeper than `level`.
Schedule no_deeper_than(int level, Schedule schedule) {
  for (PriorityList& list : schedule.lists) {
    list.greatest_level = std::min(list.greatest_level, level);
  }
  return schedule;
}

/// Of the imagined runs from `start` on, which last until `scene` ends, the share in which it
/// happens. The bodies at `unsteady` places turn a little in every step.
template <typename HasHappened>
double share_of_runs(const HasHappened& has_happened, World start, double time_s,
                     const std::vector<std::size_t>& unsteady, const StagedScene& scene,
                     const Imagination& by, RandomStream& draws) {
  start.set_schedule(no_deeper_than(by.level, start.settings().schedule));
  const std::int64_t steps = steps_until(scene.whole_s() - time_s, by.step_hz);
  Course course(scene.viewer, by.step_hz, by.tests_per_step);
  const Vector3 axis = scene.viewer.eye.normalized();
  RandomStream of_pair = draws;
  double sign = 1.0;
  const auto turn_headings = [&](World& world) {
    for (const std::size_t body : unsteady) {
      const double angle_rad = sign * kRadiansPerDegree * by.heading_noise_deg * draw_normal(draws);
      Vector3& momentum = world.mutable_states()[body].linear_momentum;
      momentum = Eigen::AngleAxisd(angle_rad, axis) * momentum;
    }
  };
  std::int64_t happened = 0;
  for (std::int64_t run = 0; run < by.runs; ++run) {
    const bool is_second = by.in_pairs && run % 2 == 1;
    sign = is_second ? -1.0 : 1.0;
    if (is_second) {
      draws = of_pair;
    } else {
      of_pair = draws;
    }
    World world = start;
    happened += course.leads_to(has_happened, world, steps, turn_headings) ? 1 : 0;
  }
  return static_cast<double>(happened) / static_cast<double>(by.runs);
}

}  // namespace

Instant last_shown_instant(const StagedScene& scene) {
  SceneRun run(scene_at_onset(scene));
  const std::int64_t steps = steps_until(scene.duration_s, scene.step_hz);
  while (run.number() < steps) {
    run.step_whole();
  }
  return {static_cast<double>(run.number()) / scene.step_hz, run.world().states()};
}

std::optional<Meeting> first_meeting(const StagedScene& scene) {
  if (!scene.goal) {
    return std::nullopt;
  }
  SceneRun run(scene_at_onset(scene));
  const auto mine = static_cast<std::int32_t>(scene.goal->body);
  const std::int64_t steps = steps_until(scene.whole_s(), scene.step_hz);
  while (run.number() < steps) {
    const StepReport& report = run.step_whole();
    for (const CollisionReport& collision : report.collisions) {
      const auto& [a, b] = collision.bodies;
      const std::int32_t other = a == mine ? b : a;
      if ((a == mine || b == mine) && !is_wall(other) &&
          scene.world.models()[static_cast<std::size_t>(other)].inverse_mass > 0.0) {
        return Meeting{{static_cast<double>(run.number() - 1) / scene.step_hz, run.before()},
                       static_cast<std::size_t>(other)};
      }
    }
  }
  return std::nullopt;
}

bool gets_through(const StagedScene& scene, std::optional<std::size_t> without) {
  Rest rest = rest_of(scene, scene.start, without);
  Course course(scene.viewer, scene.step_hz, kUnlimitedTests);
  return course.leads_to(passage_of(*scene.goal, rest.body), rest.world,
                         steps_until(scene.whole_s() - scene.still_s, scene.step_hz),
                         [](const World& /*as_it_is*/) {});
}

double imagined_share(const StagedScene& scene, const Meeting& from, const Imagination& by,
                      RandomStream& draws) {
  Rest start = rest_of(scene, from.states, from.other);
  return share_of_runs(passage_of(*scene.goal, start.body), std::move(start.world), from.time_s,
                       {start.body}, scene, by, draws);
}

double imagined_touching(const StagedScene& scene, const Instant& from, const BodyPair& pair,
                         const Imagination& by, RandomStream& draws) {
  const auto touch = [&](const World& /*now*/, const StepReport& report) {
    return std::any_of(report.collisions.begin(), report.collisions.end(),
                       [&](const CollisionReport& collision) {
                         const BodyPair& touching = collision.bodies;
                         return (touching.a == pair.a && touching.b == pair.b) ||
                                (touching.a == pair.b && touching.b == pair.a);
                       });
  };
  std::vector<std::size_t> unsteady;
  for (std::size_t body = 0; body < from.states.size(); ++body) {
    if (scene.world.models()[body].inverse_mass > 0.0) {
      unsteady.push_back(body);
    }
  }
  return share_of_runs(touch, World(scene.world.models(), from.states, scene.world.settings()),
                       from.time_s, unsteady, scene, by, draws);
}

}  // namespace impetus::inline observers
