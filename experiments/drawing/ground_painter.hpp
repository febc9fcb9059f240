// Draws the ground of a scene that has one: a level plane, plain or in fields, that fades into the
// picture's grey far away.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/drawing/gl_parts.hpp"
#include "experiments/drawing/scene_lights.hpp"
#include "experiments/record/ports.hpp"

namespace impetus::inline drawing {

/// Draws grounds.
class GroundPainter {
 public:
  GroundPainter();

  /// Draws into the current target and viewport, which the viewer's screen fills exactly, with the
  /// depths of the meshes; nothing where the eye is not above the ground. Precondition: the
  /// appearance has a ground.
  void paint(const Appearance& appearance, const Viewer& viewer, const SceneLights& lights);

 private:
  ShaderProgram program_;
  GlName arrangement_{GlName::Kind::kVertexArray};
};

}  // namespace impetus::inline drawing
