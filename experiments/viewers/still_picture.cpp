// SPDX-License-Identifier: MIT
#include "experiments/viewers/still_picture.hpp"

#include <utility>

#include "experiments/drawing/scene_painter.hpp"
#include "experiments/run/live_run.hpp"
#include "experiments/window/gl_window.hpp"

namespace impetus::inline viewers {

Pixels still_picture(StagedScene scene, double time_s, const PictureSize& size,
                     const Clock& clock) {
  constexpr std::uint64_t kSeed = 1;
  LiveRun live(std::move(scene), kSeed, &clock);
  const std::vector<Pose> poses = live.poses_at(time_s);
  const GlWindow window(unseen_window(size));
  ScenePainter painter;
  const PixelArea whole{0, 0, size.width_px, size.height_px};
  painter.paint(picture_of(live.scene(), poses, time_s, {}), whole);
  return window_pixels(whole);
}

}  // namespace impetus::inline viewers
