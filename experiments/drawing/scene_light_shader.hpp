// What shaders know of a scene's own lights: shadows, textures, and the colours that follow.
// SPDX-License-Identifier: MIT
#pragma once

namespace impetus::inline drawing {

/// How the surfaces of a scene that has an appearance are lit, in the shaders' own language;
/// follows kLightingShader. Places are metres from the eye, directions unit vectors as the viewer
/// sees them, colours sRGB.
///   lit_body     the colour in which a body is seen
///   lit_floor    that of a matt surface on which bodies stand
///   lit_wall     that of a wall which has its own tone and only takes shadows
inline constexpr const char* kSceneLightShader = R"(
const int kMostLights = 4;
const int kLooks = 4;                  // at a map, along each side
uniform vec3 world_up;
uniform int light_count;
uniform vec3 lights[kMostLights];      // towards each
uniform float strengths[kMostLights];
uniform mat4 to_map[kMostLights];      // each light's: 0 to 1 within it
uniform vec4 shaded[kMostLights];      // part of each map beyond which nothing is in the way
uniform sampler2DArrayShadow maps;
uniform float look_apart;              // on a map
uniform float off_surface;             // metres: a surface is not in its own way
uniform float cast_share;
uniform float gloss_share;
uniform mat4 to_floor;                 // 0 to 1 within the floor's map; third, 0 on the floor
uniform sampler2D closed;              // how closed the floor is
uniform float contact_share;

vec3 turned(vec4 turn, vec3 v) {
  return v + 2.0 * cross(turn.xyz, cross(turn.xyz, v) + turn.w * v);
}

// Looks are counted before the loop, which renderers without a card leave early; a branch about it
// they would not take.
float arriving(int light, vec3 from_eye) {
  vec3 at = (to_map[light] * vec4(from_eye, 1.0)).xyz;
  vec4 part = shaded[light];
  bool clear = cast_share == 0.0 || any(lessThan(at.xy, part.xy)) || any(greaterThan(at.xy, part.zw));
  int looks = clear ? 0 : kLooks * kLooks;
  float open = 0.0;
  for (int look = 0; look < looks; ++look) {
    vec2 aside = vec2(look % kLooks, look / kLooks) - 0.5 * float(kLooks - 1);
    open += texture(maps, vec4(at.xy + look_apart * aside, float(light), at.z));
  }
  return clear ? 1.0 : 1.0 - cast_share * (1.0 - open / float(kLooks * kLooks));
}

vec3 ambient(vec3 normal) { return mix(kFloor, kSky, 0.5 + 0.5 * dot(normal, world_up)); }

// The share of all light that bodies leave to a place of the floor.
float left_by_contact(vec3 from_eye) {
  vec3 at = (to_floor * vec4(from_eye, 1.0)).xyz;
  return abs(at.z) < 0.01 ? 1.0 - contact_share * texture(closed, at.xy).r : 1.0;
}

vec3 matt_light(vec3 from_eye, vec3 normal) {
  vec3 sum = ambient(normal);
  for (int i = 0; i < light_count; ++i) {
    float facing = dot(normal, lights[i]);
    if (facing > 0.0) {
      sum += 0.85 * strengths[i] * facing * arriving(i, from_eye);
    }
  }
  return sum * left_by_contact(from_eye);
}

vec3 lit_floor(vec3 from_eye, vec3 normal, vec3 colour) {
  return srgb_from_linear(min(linear_from_srgb(colour) * matt_light(from_eye, normal), 1.0));
}

vec3 lit_wall(vec3 from_eye, vec3 normal, vec3 colour) {
  vec3 open = ambient(normal);
  for (int i = 0; i < light_count; ++i) {
    open += 0.85 * strengths[i] * max(dot(normal, lights[i]), 0.0);
  }
  return srgb_from_linear(linear_from_srgb(colour) * matt_light(from_eye, normal) / open);
}

// Random numbers by place alone, the same on every card: whole numbers only. (Jarzynski and Olano
// 2020, pcg3d)
float random_at(ivec3 cell) {
  uvec3 v = uvec3(cell) * 1664525u + 1013904223u;
  v.x += v.y * v.z;
  v.y += v.z * v.x;
  v.z += v.x * v.y;
  v ^= v >> 16u;
  v.x += v.y * v.z;
  return float(v.x >> 8u) / 16777216.0;
}

float noise(vec3 p) {
  ivec3 cell = ivec3(floor(p));
  vec3 within = fract(p);
  vec3 s = within * within * (3.0 - 2.0 * within);
  vec4 near = vec4(random_at(cell), random_at(cell + ivec3(1, 0, 0)),
                   random_at(cell + ivec3(0, 1, 0)), random_at(cell + ivec3(1, 1, 0)));
  vec4 far = vec4(random_at(cell + ivec3(0, 0, 1)), random_at(cell + ivec3(1, 0, 1)),
                  random_at(cell + ivec3(0, 1, 1)), random_at(cell + ivec3(1, 1, 1)));
  vec4 between = mix(near, far, s.z);
  vec2 row = mix(between.xy, between.zw, s.y);
  return mix(row.x, row.y, s.x);
}

float rough(vec3 p) { return 0.55 * noise(p) + 0.3 * noise(2.03 * p) + 0.15 * noise(4.01 * p); }

// How dark a texture is at a place of the body, 0 to 1; `made_of` is texture, number and radius.
float darkness(vec3 on_body, vec3 made_of) {
  vec3 p = on_body / made_of.z;
  vec3 own = p + 7.3 * made_of.y;
  if (made_of.x == 1.0) {  // wood: rings about an axis, and fibres along it
    float ring = fract(3.5 * length(p.xz + vec2(0.45, 0.2)) + 0.9 * rough(1.3 * own));
    float fibres = noise(own * vec3(22.0, 2.0, 22.0));
    return 0.75 * smoothstep(0.15, 0.85, ring) * (1.0 - smoothstep(0.9, 1.0, ring)) + 0.25 * fibres;
  }
  if (made_of.x == 2.0) {  // marble: thin veins where a wave that is disturbed turns its sign
    float wave = sin(3.0 * p.x + 2.0 * p.y + 9.0 * rough(1.6 * own));
    return 0.9 * pow(1.0 - abs(wave), 3.0) + 0.1 * noise(6.0 * own);
  }
  float grain = noise(9.0 * own) * 0.7 + noise(19.0 * own) * 0.3;  // speckles
  return 0.55 * smoothstep(0.5, 0.72, grain);
}

vec3 lit_body(vec3 from_eye, vec3 normal, vec3 on_body, vec3 colour, vec3 made_of) {
  vec3 own = linear_from_srgb(colour);
  if (made_of.x > 0.0) {
    own *= mix(1.15, 0.35, darkness(on_body, made_of));
  }
  vec3 towards_eye = -normalize(from_eye);
  vec3 matt = ambient(normal);
  float mirrored = 0.0;
  for (int i = 0; i < light_count; ++i) {
    float facing = dot(normal, lights[i]);
    if (facing > 0.0) {
      float light = strengths[i] * arriving(i, from_eye + off_surface * (normal + lights[i]));
      matt += 0.85 * light * facing;
      mirrored += light * pow(max(dot(normal, normalize(lights[i] + towards_eye)), 0.0), 48.0);
    }
  }
  return srgb_from_linear(min(own * matt + gloss_share * mirrored, 1.0));
}
)";

}  // namespace impetus::inline drawing
