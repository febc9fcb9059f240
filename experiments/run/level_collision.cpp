// SPDX-License-Identifier: MIT
#include "experiments/run/level_collision.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "engine/numerics/at.hpp"
#include "engine/numerics/elementary_functions.hpp"
#include "experiments/run/collision_truth.hpp"
#include "experiments/run/scene_run.hpp"
#include "experiments/settings/input_error.hpp"
#include "experiments/tables/number_text.hpp"

namespace impetus::inline run {
namespace {

/// One list that stops at `level`, and reaches it whatever the budget.
Schedule only_level(int level) {
  Schedule schedule;
  schedule.lists = {{1.0, level, level}};
  return schedule;
}

/// Parts of one figure fold onto each other by their hinge: alone they would not.
bool are_of_one_figure(const World& world, const BodyPair& pair) {
  const std::vector<Figure>& figures = world.settings().figures;
  return std::any_of(figures.begin(), figures.end(), [&](const Figure& figure) {
    return figure.has_part(pair.a) && figure.has_part(pair.b);
  });
}

/// The scene's bodies that collide first, and the step in which they do.
struct FirstCollision {
  BodyPair bodies;
  std::int64_t step{0};
};

std::optional<FirstCollision> first_collision(SceneRun run) {
  const StagedScene& scene = run.scene();
  const auto steps = static_cast<std::int64_t>(std::ceil(scene.duration_s * scene.step_hz));
  std::optional<FirstCollision> with_wall;
  for (std::int64_t step = 1; step <= steps; ++step) {
    for (const CollisionReport& collision : run.step_whole().collisions) {
      if (are_of_one_figure(run.world(), collision.bodies)) {
        continue;
      }
      if (!is_wall(collision.bodies.b)) {
        return FirstCollision{collision.bodies, step};
      }
      with_wall = with_wall.value_or(FirstCollision{collision.bodies, step});
    }
  }
  return with_wall;
}

/// The two bodies alone, at a step when they are on their way to each other.
struct Approach {
  std::vector<std::size_t> bodies;
  std::vector<BodyState> states;
  std::int64_t step{0};
  std::int64_t contact_step{0};  ///< when they meet at the finest level
  bool hinged{false};            ///< alone they fly a little otherwise, and may meet a little later
};

std::vector<BodyState> states_of(const World& world, const std::vector<std::size_t>& bodies) {
  std::vector<BodyState> states;
  states.reserve(bodies.size());
  for (const std::size_t body : bodies) {
    states.push_back(world.states()[body]);
  }
  return states;
}

/// Whether hinges disturb either in every step.
bool are_hinged(const World& world, const BodyPair& pair) {
  const std::vector<Figure>& figures = world.settings().figures;
  return std::any_of(figures.begin(), figures.end(), [&](const Figure& figure) {
    return figure.has_part(pair.a) || figure.has_part(pair.b);
  });
}

/// From where both fly undisturbed until they meet: the onset, or what either met last; parts of
/// figures for the last step alone.
Approach approach_to(const FirstCollision& first, SceneRun run) {
  Approach approach;
  approach.contact_step = first.step;
  approach.bodies = {at(first.bodies.a)};
  if (!is_wall(first.bodies.b)) {
    approach.bodies.push_back(at(first.bodies.b));
  }
  approach.states = states_of(run.world(), approach.bodies);
  approach.hinged = are_hinged(run.world(), first.bodies);
  for (std::int64_t step = 1; step < first.step; ++step) {
    const StepReport& report = run.step_whole();
    const bool disturbed =
        std::any_of(report.collisions.begin(), report.collisions.end(),
                    [&first](const CollisionReport& collision) {
                      const BodyPair& pair = collision.bodies;
                      return pair.a == first.bodies.a || pair.b == first.bodies.a ||
                             pair.a == first.bodies.b || pair.b == first.bodies.b;
                    });
    if (disturbed || approach.hinged) {
      approach.states = states_of(run.world(), approach.bodies);
      approach.step = step;
    }
  }
  return approach;
}

/// The bodies of the approach alone in the scene, at one level.
SceneRun run_alone(const Approach& approach, StagedScene scene, int level) {
  std::vector<BodyModel> models;
  for (const std::size_t body : approach.bodies) {
    models.push_back(scene.world.models()[body]);
  }
  WorldSettings settings = scene.world.settings();
  settings.schedule = only_level(level);
  settings.imposed_hold_s = 0.0;
  settings.imposed_spin.reset();
  settings.figures.clear();
  if (approach.bodies.size() > 1) {
    settings.enclosure.reset();
  }
  scene.world = World(std::move(models), approach.states, std::move(settings));
  scene.world.watch_node_contacts(true);
  return SceneRun(std::move(scene));
}

/// Steps in which the bodies move by about half a body's size.
std::int64_t steps_aside(const World& world, const StagedScene& scene) {
  constexpr double kShare = 0.5;
  double size_m = 0.0;
  Vector3 relative = Vector3::Zero();
  for (std::size_t body = 0; body < world.models().size(); ++body) {
    size_m = std::max(size_m, world.models()[body].tree->bounding_radius_m());
    relative += (body == 0 ? 1.0 : -1.0) * velocity(world.models()[body], world.states()[body]);
  }
  const double step_m = relative.norm() / scene.step_hz;
  constexpr std::int64_t kMost = 2400;
  return step_m > 0.0 ? std::clamp<std::int64_t>(std::llround(kShare * size_m / step_m), 1, kMost)
                      : 1;
}

CollisionMoment moment_of(const World& world, std::int64_t step, const StagedScene& scene) {
  CollisionMoment moment;
  moment.time_s = static_cast<double>(step) / scene.step_hz;
  for (std::size_t body = 0; body < world.models().size(); ++body) {
    moment.poses.push_back(world.states()[body].pose);
    moment.velocities.push_back(velocity(world.models()[body], world.states()[body]));
  }
  return moment;
}

/// The nodes that overlap at the level that a collision reached.
std::vector<RoundedBox> touching_nodes(const World& world, int level) {
  std::vector<PlacedTree> placed;
  for (std::size_t body = 0; body < world.models().size(); ++body) {
    placed.emplace_back(*world.models()[body].tree);
    placed.back().move_to(world.states()[body].pose);
  }
  PairRefinement pair = placed.size() > 1
                            ? PairRefinement(placed[0], placed[1], level)
                            : PairRefinement(placed[0], *world.settings().enclosure, level);
  while (!pair.resolved()) {
    pair.refine_one_block();
  }
  std::array<std::vector<std::int32_t>, 2> nodes;
  for (const NodePair& touching : pair.overlapping()) {
    nodes[0].push_back(touching.a);
    nodes[1].push_back(touching.b);
  }
  std::vector<RoundedBox> boxes;
  for (std::size_t body = 0; body < placed.size(); ++body) {
    std::sort(nodes[body].begin(), nodes[body].end());
    nodes[body].erase(std::unique(nodes[body].begin(), nodes[body].end()), nodes[body].end());
    for (const std::int32_t node : nodes[body]) {
      boxes.push_back(rounded_box(placed[body].world_volume(node)));
    }
  }
  return boxes;
}

void measure_gap(const Approach& approach, const StagedScene& scene, const BodyPair& pair,
                 LevelCollision& row) {
  const CollisionMoment& contact = row.moments[kAtContact];
  const Viewer viewer = scene.viewer_at_time(contact.time_s);
  const DrawnBody& look = scene.looks[approach.bodies[0]];
  const CollisionTruth truth =
      is_wall(pair.b)
          ? measure_wall_truth(look, contact.poses[0], *scene.world.settings().enclosure,
                               kEnclosure - pair.b, viewer)
          : measure_truth(look, contact.poses[0], scene.looks[approach.bodies[1]], contact.poses[1],
                          viewer);
  row.gap_m = truth.gap_m;
  row.gap_arcmin = truth.gap_arcmin;
}

double fit_error_m(const World& world, int level) {
  double sum_m = 0.0;
  for (const BodyModel& body : world.models()) {
    sum_m += body.tree->fit_error_m(std::min(level, body.tree->level_count() - 1));
  }
  return sum_m;
}

LevelCollision at_level(const Approach& approach, const StagedScene& scene, int level) {
  SceneRun run = run_alone(approach, scene, level);
  const World& world = run.world();
  const std::int64_t aside = steps_aside(world, scene);
  LevelCollision row;
  row.level = level;
  row.fit_error_m = fit_error_m(world, level);
  std::vector<CollisionMoment> course{moment_of(world, approach.step, scene)};
  StepReport report;
  std::int64_t step = approach.step;
  while (report.collisions.empty()) {
    if (++step > approach.contact_step + (approach.hinged ? aside : 0)) {
      throw std::logic_error("what touches at the finest level was apart at a coarser one");
    }
    report = run.step_whole();
    course.push_back(moment_of(world, step, scene));
  }
  const auto contact = static_cast<std::int64_t>(course.size()) - 1;
  row.moments[kBeforeContact] =
      course[static_cast<std::size_t>(std::max<std::int64_t>(0, contact - aside))];
  row.moments[kAtContact] = course.back();
  for (const Contact& node : report.node_contacts) {
    row.node_contacts.push_back(node.touch.point);
  }
  for (const CollisionReport& collision : report.collisions) {
    const std::vector<TouchPoint> touches = touch_points(report, collision);
    row.contacts.insert(row.contacts.end(), touches.begin(), touches.end());
  }
  row.touching = touching_nodes(world, level);
  measure_gap(approach, scene, report.collisions.front().bodies, row);
  for (std::int64_t after = 0; after < aside; ++after) {
    static_cast<void>(run.step_whole());
  }
  row.moments[kAfterContact] = moment_of(world, step + aside, scene);
  return row;
}

const TouchPoint& deepest(const std::vector<TouchPoint>& contacts) {
  return *std::max_element(
      contacts.begin(), contacts.end(),
      [](const TouchPoint& x, const TouchPoint& y) { return x.depth_m < y.depth_m; });
}

}  // namespace

int finest_level_of(const World& world) {
  int finest = 0;
  for (const BodyModel& body : world.models()) {
    finest = std::max(finest, body.tree->level_count() - 1);
  }
  return finest;
}

CollisionByLevel collision_by_level(const StagedScene& scene) {
  SceneRun finest(scene);
  const int finest_level = finest_level_of(scene.world);
  finest.world().set_schedule(only_level(finest_level));
  const auto first = first_collision(finest);
  if (!first) {
    throw InputError(printed("expected a collision within the scene's %g s, but nothing touches",
                             scene.duration_s));
  }
  const Approach approach = approach_to(*first, finest);
  CollisionByLevel result;
  result.bodies = approach.bodies;
  for (int level = 0; level <= finest_level; ++level) {
    result.levels.push_back(at_level(approach, scene, level));
  }
  const Vector3 exact = deepest(result.levels.back().contacts).normal;
  for (LevelCollision& row : result.levels) {
    const Vector3 normal = deepest(row.contacts).normal;
    row.normal_off_deg = degrees(atan2_rad(normal.cross(exact).norm(), normal.dot(exact)));
  }
  return result;
}

}  // namespace impetus::inline run
