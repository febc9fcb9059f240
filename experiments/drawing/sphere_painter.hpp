// Draws spheres in exact perspective by one of the sphere shaders, all in one call.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "engine/scheduling/viewer.hpp"
#include "engine/volumes/sphere.hpp"
#include "experiments/drawing/pixel_area.hpp"

namespace impetus::inline drawing {

struct ColouredSphere {
  Sphere sphere;                  ///< in world
  std::array<float, 3> colour{};  ///< sRGB, 0–1
};

/// Whether what is drawn later can be hidden by it.
enum class HidesOthers { kNo, kYes };

class SpherePainter {
 public:
  /// `fragment_shader` follows kLightingShader. Needs a current OpenGL 3.3 context, now and for
  /// every call.
  SpherePainter(const char* fragment_shader, HidesOthers hides);
  ~SpherePainter();
  SpherePainter(const SpherePainter&) = delete;
  SpherePainter& operator=(const SpherePainter&) = delete;

  /// Draws those that can be seen, farthest first, into the area of the current target, which the
  /// viewer's screen fills exactly.
  void paint(const std::vector<ColouredSphere>& spheres, const Viewer& viewer,
             const PixelArea& area);

 private:
  HidesOthers hides_;
  unsigned program_{0};
  unsigned arrangement_{0};
  unsigned instances_{0};
};

}  // namespace impetus::inline drawing
