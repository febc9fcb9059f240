// SPDX-License-Identifier: MIT
#include "experiments/observers/imagined_runs.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "experiments/observers/draws.hpp"
#include "experiments/run/scene_run.hpp"

namespace impetus::inline observers {
namespace {

/// The scene at its start.
StagedScene from_start(const StagedScene& scene) {
  StagedScene anew = scene;
  anew.world = World(scene.world.models(), scene.start, scene.world.settings());
  return anew;
}

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

/// Steps until the body is through, or its time is over.
class Passage {
 public:
  Passage(const StagedScene& scene, std::size_t body, double step_hz, std::int64_t tests)
      : goal_(*scene.goal), body_(body), meter_(tests) {
    input_.dt_s = 1.0 / step_hz;
    input_.viewer = scene.viewer;
  }

  /// `before_step` may change the world.
  template <typename BeforeStep>
  bool leads_through(World& world, std::int64_t steps, const BeforeStep& before_step) {
    for (std::int64_t step = 0; step < steps; ++step) {
      before_step(world);
      world.step(input_, meter_);
      if (goal_.is_passed_at(world.states()[body_].pose.position)) {
        return true;
      }
    }
    return false;
  }

 private:
  const Goal& goal_;
  std::size_t body_;
  StepInput input_;
  FixedWork meter_;
};

std::int64_t steps_in(double seconds, double step_hz) {
  constexpr double kOfAStep = 1e-9;
  return static_cast<std::int64_t>(std::ceil(seconds * step_hz - kOfAStep));
}

/// No list of the schedule refines deeper than `level`.
Schedule no_deeper_than(int level, Schedule schedule) {
  for (PriorityList& list : schedule.lists) {
    list.greatest_level = std::min(list.greatest_level, level);
  }
  return schedule;
}

}  // namespace

std::optional<Meeting> first_meeting(const StagedScene& scene) {
  if (!scene.goal) {
    return std::nullopt;
  }
  SceneRun run(from_start(scene));
  const auto mine = static_cast<std::int32_t>(scene.goal->body);
  const std::int64_t steps = steps_in(scene.duration_s, scene.step_hz);
  while (run.number() < steps) {
    const StepReport& report = run.step_whole();
    for (const CollisionReport& collision : report.collisions) {
      const auto& [a, b] = collision.bodies;
      const std::int32_t other = a == mine ? b : a;
      if ((a == mine || b == mine) && !is_wall(other) &&
          scene.world.models()[static_cast<std::size_t>(other)].inverse_mass > 0.0) {
        return Meeting{static_cast<double>(run.number() - 1) / scene.step_hz,
                       static_cast<std::size_t>(other), run.before()};
      }
    }
  }
  return std::nullopt;
}

bool gets_through(const StagedScene& scene, std::optional<std::size_t> without) {
  Rest rest = rest_of(scene, scene.start, without);
  Passage passage(scene, rest.body, scene.step_hz, kUnlimitedTests);
  return passage.leads_through(rest.world, steps_in(scene.duration_s, scene.step_hz),
                               [](const World& /*as_it_is*/) {});
}

double imagined_share(const StagedScene& scene, const Meeting& from, const Imagination& by,
                      RandomStream& draws) {
  Rest start = rest_of(scene, from.states, from.other);
  start.world.set_schedule(no_deeper_than(by.level, start.world.settings().schedule));
  const std::int64_t steps = steps_in(scene.duration_s - from.time_s, by.step_hz);
  Passage passage(scene, start.body, by.step_hz, by.tests_per_step);
  const Vector3 axis = scene.viewer.eye.normalized();
  RandomStream of_pair = draws;
  double sign = 1.0;
  const auto turn_heading = [&](World& world) {
    const double angle_rad = sign * kRadiansPerDegree * by.heading_noise_deg * draw_normal(draws);
    Vector3& momentum = world.mutable_states()[start.body].linear_momentum;
    momentum = Eigen::AngleAxisd(angle_rad, axis) * momentum;
  };
  std::int64_t through = 0;
  for (std::int64_t run = 0; run < by.runs; ++run) {
    sign = run % 2 == 0 ? 1.0 : -1.0;
    if (run % 2 == 0) {
      of_pair = draws;
    } else {
      draws = of_pair;
    }
    World world = start.world;
    through += passage.leads_through(world, steps, turn_heading) ? 1 : 0;
  }
  return static_cast<double>(through) / static_cast<double>(by.runs);
}

}  // namespace impetus::inline observers
