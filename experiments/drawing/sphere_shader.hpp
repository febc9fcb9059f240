// The shaders that cast a sphere: light, shade and edge for every pixel of its image, or a
// translucent volume.
// SPDX-License-Identifier: MIT
#pragma once

namespace impetus::inline drawing {

/// One rectangle on the glass per sphere; lengths in metres, the eye at the origin.
inline constexpr const char* kSphereVertexShader = R"(#version 330 core
layout(location = 0) in vec4 bounds;  // left, right, bottom, top on the glass
layout(location = 1) in vec4 sphere;  // centre, radius
layout(location = 2) in vec3 colour;  // sRGB
uniform vec3 glass;                   // width, height, distance
uniform vec2 margin;                  // two pixels
out vec3 ray;
flat out vec4 body;
flat out vec3 paint;

void main() {
  vec2 low = vec2(bounds.x, bounds.z) - margin;
  vec2 high = vec2(bounds.y, bounds.w) + margin;
  vec2 corner = mix(low, high, vec2(gl_VertexID & 1, gl_VertexID >> 1));
  ray = vec3(corner, -glass.z);
  body = sphere;
  paint = colour;
  gl_Position = vec4(2.0 * corner / glass.xy, 0.0, 1.0);
}
)";

/// Follows kLightingShader.
inline constexpr const char* kSphereFragmentShader = R"(
in vec3 ray;
flat in vec4 body;
flat in vec3 paint;
out vec4 seen;

void main() {
  vec3 direction = normalize(ray);
  float radius = body.w;
  float beside = length(cross(body.xyz, direction));  // of the ray from the centre
  float pixel = max(length(vec2(dFdx(beside), dFdy(beside))), 1e-9);
  float covered = clamp(0.5 - (beside - radius) / pixel, 0.0, 1.0);
  if (covered <= 0.0) {
    discard;
  }
  float along = dot(body.xyz, direction);
  vec3 hit = direction * (along - sqrt(max(radius * radius - beside * beside, 0.0)));
  vec3 normal = normalize(hit - body.xyz);
  seen = vec4(light(normal, -direction, paint), covered);
  gl_FragDepth = clamp(1.0 + kNear / hit.z, 0.0, 1.0);
}
)";

/// Follows kLightingShader: a translucent ball with a rim of a pixel or two.
inline constexpr const char* kVolumeFragmentShader = R"(
const float kInside = 0.09;
const float kRim = 0.75;
in vec3 ray;
flat in vec4 body;
flat in vec3 paint;
out vec4 seen;

void main() {
  vec3 direction = normalize(ray);
  float radius = body.w;
  float beside = length(cross(body.xyz, direction));  // of the ray from the centre
  float pixel = max(length(vec2(dFdx(beside), dFdy(beside))), 1e-9);
  float within = (radius - beside) / pixel;  // pixels from the rim
  if (within <= 0.0) {
    discard;
  }
  float rim = clamp(within, 0.0, 1.0) * clamp(2.2 - within, 0.0, 1.0);
  float along = dot(body.xyz, direction);
  vec3 hit = direction * (along - sqrt(max(radius * radius - beside * beside, 0.0)));
  seen = vec4(paint, mix(kInside, kRim, rim));
  gl_FragDepth = clamp(1.0 + kNear / hit.z, 0.0, 1.0);
}
)";

}  // namespace impetus::inline drawing
