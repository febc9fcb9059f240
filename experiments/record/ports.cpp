// SPDX-License-Identifier: MIT
#include "experiments/record/ports.hpp"

namespace impetus::inline record {

Picture picture_of(const StagedScene& scene, const std::vector<Pose>& poses, double time_s,
                   const SessionProgress& progress) {
  Picture picture;
  picture.viewer = scene.viewer_at_time(time_s);
  picture.progress = progress;
  if (!poses.empty()) {
    picture.enclosure = scene.world.settings().enclosure;
    picture.appearance = scene.appearance;
  }
  for (std::size_t body = 0; body < poses.size(); ++body) {
    picture.bodies.push_back({poses[body], scene.looks[body].at(time_s)});
  }
  if (!poses.empty()) {
    flash(scene.flashing, time_s, picture.bodies);
  }
  return picture;
}

}  // namespace impetus::inline record
