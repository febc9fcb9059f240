// SPDX-License-Identifier: MIT
#include "experiments/run/pairs_of_step.hpp"

#include <cstddef>

namespace impetus::inline run {
namespace {

std::vector<MovedBound> moved_bounds(const World& world, const std::vector<BodyState>& before) {
  std::vector<MovedBound> bounds;
  for (std::size_t body = 0; body < before.size(); ++body) {
    const BodyModel& model = world.models()[body];
    const Vector3& place = world.states()[body].pose.position;
    bounds.push_back({{place, model.tree->bounding_radius_m()},
                      (place - before[body].pose.position).norm(),
                      model.inverse_mass > 0.0});
  }
  return bounds;
}

void add_wall_pairs(const Enclosure& walls, const std::vector<MovedBound>& bounds,
                    std::vector<PairBounds>& pairs) {
  for (std::size_t body = 0; body < bounds.size(); ++body) {
    const Sphere& bound = bounds[body].bound;
    if (bounds[body].movable && reaches_wall(walls, bound)) {
      pairs.push_back({{static_cast<std::int32_t>(body), kEnclosure}, bound, bound});
    }
  }
}

}  // namespace

std::vector<ScheduledPair> pairs_of_step(const World& world, const std::vector<BodyState>& before,
                                         const StepInput& input) {
  const std::vector<MovedBound> bounds = moved_bounds(world, before);
  std::vector<PairBounds> pairs = candidate_pairs(bounds);
  if (world.settings().enclosure) {
    add_wall_pairs(*world.settings().enclosure, bounds, pairs);
  }
  for (PairBounds& pair : pairs) {
    const auto a = static_cast<std::size_t>(pair.pair.a);
    const std::size_t b = is_wall(pair.pair.b) ? a : static_cast<std::size_t>(pair.pair.b);
    pair.velocity_a = velocity(world.models()[a], before[a]);
    pair.velocity_b = velocity(world.models()[b], before[b]);
    pair.fit_error_m = world.models()[a].tree->fit_error_m(0);
    if (!is_wall(pair.pair.b)) {
      pair.fit_error_m += world.models()[b].tree->fit_error_m(0);
    }
  }
  return scheduled(pairs, world.settings().schedule, input.viewer, input.fixation, input.region);
}

}  // namespace impetus::inline run
