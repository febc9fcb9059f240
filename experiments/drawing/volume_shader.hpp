// The shaders that draw a volume of any kind as a rounded box, in the perspective and the depth of
// the ray-cast spheres.
// SPDX-License-Identifier: MIT
#pragma once

namespace impetus::inline drawing {

/// Follows kLightingShader; lengths in metres, the eye at the origin.
inline constexpr const char* kRoundedBoxVertexShader = R"(
layout(location = 0) in vec3 corner;   // of the box, ±1 each
layout(location = 1) in vec3 outward;  // unit, in the box's axes
layout(location = 2) in vec4 place;    // centre from the eye, radius
layout(location = 3) in vec3 extents;  // half
layout(location = 4) in vec4 turn;     // from the box's axes to the viewer's: x y z w
layout(location = 5) in vec3 colour;   // sRGB
uniform vec3 glass;                    // width, height, distance
out vec3 from_eye;
out vec3 upright;
flat out vec3 paint;
invariant gl_Position;

vec3 turned(vec3 v) { return v + 2.0 * cross(turn.xyz, cross(turn.xyz, v) + turn.w * v); }

void main() {
  from_eye = place.xyz + turned(corner * extents + place.w * outward);
  upright = turned(outward);
  paint = colour;
  float ahead = -from_eye.z;
  gl_Position = vec4(2.0 * glass.z * from_eye.xy / glass.xy, ahead - 2.0 * kNear, ahead);
}
)";

/// Follows kLightingShader.
inline constexpr const char* kRoundedBoxFragmentShader = R"(
in vec3 from_eye;
in vec3 upright;
flat in vec3 paint;
uniform float opacity;
out vec4 seen;

void main() {
  vec3 normal = normalize(upright);
  vec3 towards = -normalize(from_eye);
  float rim = 1.0 - max(dot(normal, towards), 0.0);  // glass is denser where it is seen aslant
  seen = vec4(light(normal, towards, paint), mix(opacity, 1.0, 0.55 * rim * rim * rim));
}
)";

}  // namespace impetus::inline drawing
