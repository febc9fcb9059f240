// Draws the enclosure as it is seen from inside: the walls that face the eye, each in its own tone.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "engine/volumes/enclosure.hpp"
#include "experiments/drawing/gl_parts.hpp"
#include "experiments/drawing/scene_lights.hpp"
#include "experiments/record/ports.hpp"

namespace impetus::inline drawing {

/// Indices (as in the enclosure) of the walls whose inside the eye can see: not those of a view
/// frustum that hold the eye and are seen from their edge.
[[nodiscard]] std::vector<int> walls_facing(const Enclosure& enclosure, const Vector3& eye);

/// The tone of a wall (sRGB, 0–1) whose inward unit normal is `normal_E` as the viewer sees it:
/// light and without colour, the floor lightest, the ceiling darkest, left and right apart.
[[nodiscard]] float wall_grey(const Vector3& normal_E);

/// Draws the walls that face the eye.
class EnclosurePainter {
 public:
  /// Walls lit by the usual light have their tones alone; by a scene's lights, shadows too.
  explicit EnclosurePainter(LitBy light);

  /// Draws into the current target and viewport, which the viewer's screen fills exactly, with
  /// the depths of the meshes. `lights` are those of walls that are lit by a scene.
  void paint(const Enclosure& enclosure, const Viewer& viewer, const SceneLights* lights = nullptr);

 private:
  ShaderProgram program_;
  GlName arrangement_{GlName::Kind::kVertexArray};
  GlName corners_{GlName::Kind::kBuffer};
};

}  // namespace impetus::inline drawing
