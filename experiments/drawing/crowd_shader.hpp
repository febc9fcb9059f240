// The shaders that draw a crowd's meshes, many in one call: each instance brings its place, turn
// and colour. Light is found at the corners: a crowd's triangles are a few pixels wide.
// SPDX-License-Identifier: MIT
#pragma once

namespace impetus::inline drawing {

/// Follows kLightingShader; lengths in metres, the eye at the origin. The perspective and the
/// depth are those of kMeshVertexShader.
inline constexpr const char* kCrowdVertexShader = R"(
layout(location = 0) in vec3 vertex;  // in the body's frame
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 place;   // of the body, from the eye
layout(location = 3) in vec4 turn;    // from the body's frame to the viewer's, a unit quaternion
layout(location = 4) in vec3 colour;  // sRGB
uniform vec3 glass;                   // width, height, distance
centroid out vec3 lit;

vec3 turned(vec3 v) {
  return v + 2.0 * cross(turn.xyz, cross(turn.xyz, v) + turn.w * v);
}

void main() {
  vec3 from_eye = turned(vertex) + place;
  lit = light(turned(normal), -normalize(from_eye), colour);
  float ahead = -from_eye.z;
  gl_Position = vec4(2.0 * glass.z * from_eye.xy / glass.xy, ahead - 2.0 * kNear, ahead);
}
)";

inline constexpr const char* kCrowdFragmentShader = R"(#version 330 core
centroid in vec3 lit;
out vec4 seen;

void main() { seen = vec4(lit, 1.0); }
)";

}  // namespace impetus::inline drawing
