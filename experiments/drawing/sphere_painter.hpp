// Draws spheres in exact perspective, all in one call: every pixel of an image asks the sphere
// itself.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "engine/volumes/sphere.hpp"
#include "experiments/drawing/gl_parts.hpp"
#include "experiments/drawing/picture_map.hpp"

namespace impetus::inline drawing {

/// A ball to be drawn.
struct ColouredSphere {
  Sphere sphere;                  ///< in world
  std::array<float, 3> colour{};  ///< sRGB, 0–1
};

/// What balls are made of: opaque ones are lit, with blended edges; clear ones have a thin rim, and
/// do not hide what is drawn later.
enum class BallKind { kOpaque, kClear };

/// Draws balls of one kind.
class SpherePainter {
 public:
  explicit SpherePainter(BallKind kind);

  /// Draws those that can be seen, farthest first, into the area of the current target, which the
  /// viewer's screen fills exactly.
  void paint(const std::vector<ColouredSphere>& spheres, const Viewer& viewer,
             const PixelArea& area);

 private:
  BallKind kind_;
  ShaderProgram program_;
  GlName arrangement_{GlName::Kind::kVertexArray};
  GlName instances_{GlName::Kind::kBuffer};
};

}  // namespace impetus::inline drawing
