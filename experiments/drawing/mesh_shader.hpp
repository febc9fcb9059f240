// The shaders that draw a mesh in the perspective and the depth of the ray-cast spheres.
// SPDX-License-Identifier: MIT
#pragma once

namespace impetus::inline drawing {

/// Follows kLightingShader; lengths in metres, the eye at the origin.
inline constexpr const char* kMeshVertexShader = R"(
layout(location = 0) in vec3 vertex;  // in the body's frame
layout(location = 1) in vec3 normal;
uniform vec3 glass;                   // width, height, distance
uniform mat3 turn;                    // from the body's frame to the viewer's
uniform vec3 place;                   // of the body, from the eye
out vec3 from_eye;
centroid out vec3 upright;

void main() {
  from_eye = turn * vertex + place;
  upright = turn * normal;
  float ahead = -from_eye.z;
  gl_Position = vec4(2.0 * glass.z * from_eye.xy / glass.xy, ahead - 2.0 * kNear, ahead);
}
)";

/// Follows kLightingShader.
inline constexpr const char* kMeshFragmentShader = R"(
in vec3 from_eye;
centroid in vec3 upright;
uniform vec3 colour;  // sRGB
out vec4 seen;

void main() {
  seen = vec4(light(normalize(upright), -normalize(from_eye), colour), 1.0);
}
)";

}  // namespace impetus::inline drawing
