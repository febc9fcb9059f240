// How any surface is lit, in the shaders' own language: put in front of a fragment shader's text.
// SPDX-License-Identifier: MIT
#pragma once

namespace impetus::inline drawing {

/// light(normal, towards_eye, colour): unit vectors as the viewer sees them, colour and result
/// sRGB. kNear and the depth 1 − kNear / distance are the same for every kind of body.
inline constexpr const char* kLightingShader = R"(#version 330 core
const vec3 kKeyLight = normalize(vec3(-0.55, 0.75, 0.60));  // from the viewer's upper left
const vec3 kSky = vec3(0.34);
const vec3 kFloor = vec3(0.17);
const float kNear = 0.01;

vec3 linear_from_srgb(vec3 c) {
  return mix(c / 12.92, pow((c + 0.055) / 1.055, vec3(2.4)), step(0.04045, c));
}
vec3 srgb_from_linear(vec3 c) {
  return mix(12.92 * c, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, c));
}

vec3 light(vec3 normal, vec3 towards_eye, vec3 colour) {
  float facing = max(dot(normal, kKeyLight), 0.0);
  vec3 ambient = mix(kFloor, kSky, 0.5 + 0.5 * normal.y);
  vec3 diffuse = linear_from_srgb(colour) * (ambient + 0.85 * facing);
  float gloss = pow(max(dot(normal, normalize(kKeyLight + towards_eye)), 0.0), 48.0);
  return srgb_from_linear(min(diffuse + 0.10 * gloss, 1.0));
}
)";

}  // namespace impetus::inline drawing
