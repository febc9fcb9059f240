// The shaders that draw a wall of the enclosure: one tone, and a thin line along its edges.
// SPDX-License-Identifier: MIT
#pragma once

namespace impetus::inline drawing {

/// Follows kLightingShader; lengths in metres, the eye at the origin. The perspective and the
/// depth are those of the meshes.
inline constexpr const char* kEnclosureVertexShader = R"(
layout(location = 0) in vec3 from_eye;
layout(location = 1) in vec2 on_wall;  // ±1 at the wall's edges
layout(location = 2) in float tone;    // sRGB
uniform vec3 glass;                    // width, height, distance
out vec2 across;
flat out float grey;

void main() {
  across = on_wall;
  grey = tone;
  float ahead = -from_eye.z;
  gl_Position = vec4(2.0 * glass.z * from_eye.xy / glass.xy, ahead - 2.0 * kNear, ahead);
}
)";

inline constexpr const char* kEnclosureFragmentShader = R"(#version 330 core
const float kHalfLine = 1.0;  // pixels: two walls share an edge
const float kLineGrey = 0.40;
in vec2 across;
flat in float grey;
out vec4 seen;

void main() {
  vec2 pixels = (1.0 - abs(across)) / max(fwidth(across), vec2(1e-6));
  float line = clamp(kHalfLine + 0.5 - min(pixels.x, pixels.y), 0.0, 1.0);
  seen = vec4(vec3(mix(grey, kLineGrey, line)), 1.0);
}
)";

}  // namespace impetus::inline drawing
