// Paints a picture: spheres in exact perspective, lit, on a neutral mid-grey ground.
//
//   eye ──── ray through a pixel of the glass ────> sphere      every pixel asks the sphere itself,
//                     |<- bounds of its image ->|               so it is round at any size
//
// The screen is the plane through the world's origin that faces the eye: a metre there is a metre
// on the glass. Edges are blended by the share of the pixel that is covered.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/session/ports.hpp"

namespace impetus {

/// A rectangle of the window in pixels, from its lower left corner.
struct PixelArea {
  int left{0};
  int bottom{0};
  int width{0};
  int height{0};
};

class ScenePainter {
 public:
  /// Needs a current OpenGL 3.3 context, now and for every call.
  ScenePainter();
  ~ScenePainter();
  ScenePainter(const ScenePainter&) = delete;
  ScenePainter& operator=(const ScenePainter&) = delete;

  /// Fills the area with a grey (sRGB, 0–1).
  void fill(const PixelArea& area, float grey);

  /// Paints ground, bodies and fixation cross; the viewer's screen fills the area exactly.
  void paint(const Picture& picture, const PixelArea& area);

 private:
  void paint_bodies(const Picture& picture);
  void paint_fixation(const ScreenGeometry& screen, const PixelArea& area);

  unsigned program_{0};
  unsigned arrangement_{0};
  unsigned instances_{0};
};

}  // namespace impetus
