// SPDX-License-Identifier: MIT
#include "experiments/drawing/scene_painter.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/numerics/elementary_functions.hpp"
#include "engine/shapes/solids/ball_meshes.hpp"
#include "experiments/drawing/gl.hpp"
#include "experiments/drawing/palette.hpp"

namespace impetus::inline drawing {
namespace {

constexpr float kCrossGrey = 0.13F;
constexpr double kCrossArmDeg = 0.6;
constexpr double kCrossThicknessDeg = 0.08;

constexpr float kShellOpacity = 0.3F;

/// Pictures of more bodies have one sample per pixel: four take twice the time where a card is
/// missing.
constexpr std::size_t kMostSmoothedBodies = 100;

bool has_mesh(const PosedBody& body) { return body.look.mesh != nullptr; }

bool is_ball(const ColouredVolume& volume) { return volume.shape.half_extents_m.isZero(0.0); }

std::vector<ColouredSphere> spheres_of(const Picture& picture) {
  std::vector<ColouredSphere> spheres;
  for (std::size_t body = 0; body < picture.bodies.size(); ++body) {
    const auto& [pose, look] = picture.bodies[body];
    if (!look.mesh) {
      spheres.push_back({{pose.position, look.radius_m},
                         look.colour,
                         pose.orientation,
                         texture_number(picture, look),
                         static_cast<float>(body)});
    }
  }
  return spheres;
}

/// Whether edges of other things than spheres are seen.
bool has_straight_edges(const Picture& picture, const std::vector<ColouredVolume>& volumes) {
  return picture.enclosure || picture.appearance ||
         std::any_of(picture.bodies.begin(), picture.bodies.end(), has_mesh) ||
         !std::all_of(volumes.begin(), volumes.end(), is_ball);
}

constexpr int kBallFineness = 4;

}  // namespace

ScenePainter::ScenePainter()
    : ball_(std::make_shared<const TriangleMesh>(icosphere_mesh(1.0, kBallFineness))) {}

void ScenePainter::fill(const PixelArea& area, float grey) {
  glEnable(GL_SCISSOR_TEST);
  glScissor(area.left, area.bottom, area.width, area.height);
  glClearColor(grey, grey, grey, 1.0F);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glDisable(GL_SCISSOR_TEST);
}

void ScenePainter::paint(const Picture& picture, const PixelArea& area,
                         const std::vector<ColouredVolume>& volumes) {
  if (picture.appearance) {
    prepare_lights(picture, area.height);
  }
  if (has_straight_edges(picture, volumes) && picture.bodies.size() <= kMostSmoothedBodies) {
    paint_multisampled(picture, volumes, area);
  } else {
    paint_all(picture, volumes, area);
  }
  if (picture.fixation_cross) {
    paint_fixation(picture.viewer.screen, area);
  }
}

void ScenePainter::paint_onto(unsigned framebuffer, const Picture& picture, const PixelArea& area,
                              const std::vector<ColouredVolume>& volumes) {
  if (picture.appearance) {
    prepare_lights(picture, area.height);
  }
  paint_multisampled(picture, volumes, {0, 0, area.width, area.height}, framebuffer);
}

void ScenePainter::paint_multisampled(const Picture& picture,
                                      const std::vector<ColouredVolume>& volumes,
                                      const PixelArea& area, unsigned framebuffer) {
  const PixelArea all{0, 0, area.width, area.height};
  target_.begin(area.width, area.height);
  paint_all(picture, volumes, all);
  target_.end_onto(area, framebuffer);
}

void ScenePainter::paint_all(const Picture& picture, const std::vector<ColouredVolume>& volumes,
                             const PixelArea& area) {
  fill(area, palette::kPictureGrey);
  glViewport(area.left, area.bottom, area.width, area.height);
  if (picture.appearance) {
    paint_lit_by_scene(picture, area);
  } else {
    paint_plainly(picture, area);
  }
  paint_volumes(picture, volumes, area);
}

// Walls and meshes first: a sphere's blended edge needs what is behind it, and each of a pixel's
// samples knows whether one of them is in front.
void ScenePainter::paint_plainly(const Picture& picture, const PixelArea& area) {
  if (picture.enclosure) {
    enclosure_.paint(*picture.enclosure, picture.viewer);
  }
  if (is_crowd(picture.bodies.size())) {
    crowd_.paint(picture, area.height);
  } else {
    meshes_.paint(picture);
  }
  balls_.paint(spheres_of(picture), picture.viewer, area);
}

void ScenePainter::prepare_lights(const Picture& picture, int height_px) {
  lit_meshes_.take_meshes(picture, height_px, picture.appearance->smooth_below_deg);
  casting_balls_.take_balls(picture, ball_);
  lights_.prepare(picture, [this] {
    lit_meshes_.draw();
    casting_balls_.draw();
  });
}

// In the same order, for the same reason.
void ScenePainter::paint_lit_by_scene(const Picture& picture, const PixelArea& area) {
  if (picture.enclosure) {
    lit_enclosure_.paint(*picture.enclosure, picture.viewer, &lights_);
  }
  if (picture.appearance->ground != GroundPattern::kNone) {
    ground_.paint(*picture.appearance, picture.viewer, lights_);
  }
  lit_mesh_painter_.paint(lit_meshes_, picture.viewer, lights_);
  lit_balls_.paint(spheres_of(picture), picture.viewer, area, &lights_);
}

void ScenePainter::paint_volumes(const Picture& picture, const std::vector<ColouredVolume>& volumes,
                                 const PixelArea& area) {
  std::vector<ColouredSphere> balls;
  std::vector<ColouredVolume> others;
  for (const ColouredVolume& volume : volumes) {
    if (is_ball(volume)) {
      ColouredSphere ball;
      ball.sphere = {volume.shape.centre, volume.shape.radius_m};
      ball.colour = volume.colour;
      balls.push_back(ball);
    } else {
      others.push_back(volume);
    }
  }
  if (!others.empty()) {
    glViewport(area.left, area.bottom, area.width, area.height);
    shells_.paint(others, picture.viewer, area.height, kShellOpacity);
  }
  if (!balls.empty()) {
    clear_balls_.paint(balls, picture.viewer, area);
  }
}

// Filled rectangles of whole pixels: a cross of even thickness is sharp on a screen of even size.
void ScenePainter::paint_fixation(const ScreenGeometry& screen, const PixelArea& area) {
  const auto pixels = [&](double deg) {
    const SineCosine angle = sine_cosine_deg(deg);
    const double length_m = screen.viewing_distance_m * angle.sine / angle.cosine;
    return static_cast<int>(std::lround(length_m / screen.width_m * area.width));
  };
  const int arm = std::max(4, pixels(kCrossArmDeg));
  const int half = std::max(1, pixels(kCrossThicknessDeg / 2.0));
  const int x = area.left + area.width / 2;
  const int y = area.bottom + area.height / 2;
  fill({x - arm, y - half, 2 * arm, 2 * half}, kCrossGrey);
  fill({x - half, y - arm, 2 * half, 2 * arm}, kCrossGrey);
}

}  // namespace impetus::inline drawing
