// SPDX-License-Identifier: MIT
#include "experiments/viewing/film_run.hpp"

#include "experiments/run/frame_poses.hpp"

namespace impetus::inline viewing {

void FilmRun::advance(double time_s) {
  contacts_.clear();
  const std::int64_t last = last_shown_step(scene(), time_s);
  while (!run_.done() && run_.next_step() <= last) {
    keep(run_.next());
  }
}

void FilmRun::keep(const StepReport& report) {
  for (const CollisionReport& collision : report.collisions) {
    FilmedContact& contact =
        contacts_.emplace_back(FilmedContact{step(), collision, touch_points(report, collision)});
    if (collision.began) {
      contact.truth = measure_truth(scene(), scene().world, collision.bodies, step());
    }
  }
}

Picture FilmRun::picture(double time_s) const {
  return picture_of(scene(), shown_poses(run_.scene_run(), time_s), time_s, {});
}

}  // namespace impetus::inline viewing
