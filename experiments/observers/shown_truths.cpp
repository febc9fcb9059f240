// SPDX-License-Identifier: MIT
#include "experiments/observers/shown_truths.hpp"

#include <algorithm>

#include "engine/numerics/elementary_functions.hpp"
#include "experiments/run/collision_truth.hpp"
#include "experiments/run/meeting.hpp"

namespace impetus::inline observers {

const CollisionRecord* first_meeting(const AttemptRecord& shown) {
  const auto met = std::find_if(
      shown.collisions.begin(), shown.collisions.end(),
      [](const CollisionRecord& collision) { return !is_wall(collision.report.bodies.b); });
  return met == shown.collisions.end() ? nullptr : &*met;
}

double longest_delay_ms(const AttemptRecord& shown) {
  double longest_s = 0.0;
  for (const CollisionRecord& collision : shown.collisions) {
    longest_s = std::max(longest_s, collision.report.imposed_hold_s);
  }
  return 1e3 * longest_s;
}

double launch_gap_arcmin(const StagedScene& scene, std::optional<int> level) {
  const Launch& launch = *scene.launch;
  if (!level) {
    return kArcminPerDegree * launch.gap_deg;
  }
  const std::vector<BodyModel>& models = scene.world.models();
  const Pose& first = launch.stops;
  const Pose& second = scene.start[launch.second].pose;
  const Quaternion to_right = Quaternion::FromTwoVectors(launch.along, Vector3::UnitX());
  const MeetingPlaces touching =
      meeting_places(*models[launch.first].tree, to_right * first.orientation,
                     *models[launch.second].tree, to_right * second.orientation, *level);
  const double apart_m = launch.along.dot(second.position - first.position);
  return kArcminPerDegree * (apart_m - (touching.b_m - touching.a_m)) /
         metres_per_degree(scene.viewer.screen.viewing_distance_m);
}

double widest_gap_arcmin(const AttemptRecord& shown, const StagedScene& scene) {
  double widest = 0.0;
  for (const CollisionRecord& collision : shown.collisions) {
    const BodyPair& bodies = collision.report.bodies;
    if (!is_wall(bodies.b)) {
      const auto& a = scene.looks[static_cast<std::size_t>(bodies.a)];
      const auto& b = scene.looks[static_cast<std::size_t>(bodies.b)];
      const Viewer viewer = scene.viewer_at_time(collision.time_s);
      widest = std::max(
          widest, measure_truth(a, collision.pose_a, b, collision.pose_b, viewer).visible_arcmin());
    }
  }
  return widest;
}

}  // namespace impetus::inline observers
