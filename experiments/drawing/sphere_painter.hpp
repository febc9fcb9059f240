// Draws spheres in exact perspective, all in one call: every pixel of an image asks the sphere
// itself.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "engine/volumes/sphere.hpp"
#include "experiments/drawing/gl_parts.hpp"
#include "experiments/drawing/picture_map.hpp"
#include "experiments/drawing/scene_lights.hpp"

namespace impetus::inline drawing {

/// A ball to be drawn.
struct ColouredSphere {
  Sphere sphere;                  ///< in world
  std::array<float, 3> colour{};  ///< sRGB, 0–1
  Quaternion orientation{Quaternion::Identity()};
  float texture{0.0F};  ///< texture_number()
  float number{0.0F};   ///< among the bodies: textures of one kind differ by it
};

/// What balls are made of: opaque ones are lit, by the usual light or by a scene's own, with
/// blended edges; clear ones have a thin rim, and do not hide what is drawn later.
enum class BallKind { kOpaque, kSceneLit, kClear };

/// Draws balls of one kind.
class SpherePainter {
 public:
  explicit SpherePainter(BallKind kind);

  /// Draws those that can be seen, farthest first, into the area of the current target, which the
  /// viewer's screen fills exactly. `lights` are for balls that are lit by a scene.
  void paint(const std::vector<ColouredSphere>& spheres, const Viewer& viewer,
             const PixelArea& area, const SceneLights* lights = nullptr);

 private:
  BallKind kind_;
  ShaderProgram program_;
  GlName arrangement_{GlName::Kind::kVertexArray};
  GlName instances_{GlName::Kind::kBuffer};
};

}  // namespace impetus::inline drawing
