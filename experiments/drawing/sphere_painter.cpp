// SPDX-License-Identifier: MIT
#include "experiments/drawing/sphere_painter.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "experiments/drawing/gl.hpp"

namespace impetus::inline drawing {
namespace {

/// One rectangle on the glass per sphere; lengths in metres, the eye at the origin.
constexpr const char* kSphereVertexShader = R"(
layout(location = 0) in vec4 bounds;  // left, right, bottom, top on the glass
layout(location = 1) in vec4 sphere;  // centre, radius
layout(location = 2) in vec3 colour;  // sRGB
layout(location = 3) in vec4 turn;    // from the body's frame to the viewer's
layout(location = 4) in vec2 surface; // texture, number
uniform vec3 glass;                   // width, height, distance
uniform vec2 margin;                  // two pixels
out vec3 ray;
flat out vec4 body;
flat out vec3 paint;
flat out vec4 turned_by;
flat out vec2 made_of;

void main() {
  vec2 low = vec2(bounds.x, bounds.z) - margin;
  vec2 high = vec2(bounds.y, bounds.w) + margin;
  vec2 corner = mix(low, high, vec2(gl_VertexID & 1, gl_VertexID >> 1));
  ray = vec3(corner, -glass.z);
  body = sphere;
  paint = colour;
  turned_by = turn;
  made_of = surface;
  gl_Position = vec4(2.0 * corner / glass.xy, 0.0, 1.0);
}
)";

/// Follows kLightingShader: where the ray through a pixel passes the sphere.
constexpr const char* kPassingRayShader = R"(
in vec3 ray;
flat in vec4 body;
flat in vec3 paint;
flat in vec4 turned_by;
flat in vec2 made_of;
out vec4 seen;

void main() {
  vec3 direction = normalize(ray);
  float radius = body.w;
  float beside = length(cross(body.xyz, direction));  // of the ray from the centre
  float pixel = max(length(vec2(dFdx(beside), dFdy(beside))), 1e-9);
  float along = dot(body.xyz, direction);
  vec3 hit = direction * (along - sqrt(max(radius * radius - beside * beside, 0.0)));
)";

/// Follows kPassingRayShader.
constexpr const char* kSphereFragmentShader = R"(
  float covered = clamp(0.5 - (beside - radius) / pixel, 0.0, 1.0);
  if (covered <= 0.0) {
    discard;
  }
  vec3 normal = normalize(hit - body.xyz);
  seen = vec4(light(normal, -direction, paint), covered);
  gl_FragDepth = clamp(1.0 + kNear / hit.z, 0.0, 1.0);
}
)";

/// Follows kSceneLightShader and kPassingRayShader.
constexpr const char* kSceneLitBallFragmentShader = R"(
  float covered = clamp(0.5 - (beside - radius) / pixel, 0.0, 1.0);
  if (covered <= 0.0) {
    discard;
  }
  vec3 normal = normalize(hit - body.xyz);
  vec3 on_body = turned(vec4(-turned_by.xyz, turned_by.w), hit - body.xyz);
  seen = vec4(lit_body(hit, normal, on_body, paint, vec3(made_of, radius)), covered);
  gl_FragDepth = clamp(1.0 + kNear / hit.z, 0.0, 1.0);
}
)";

/// Follows kPassingRayShader: a translucent ball with a rim of a pixel or two.
constexpr const char* kClearBallFragmentShader = R"(
  const float kInside = 0.09;
  const float kRim = 0.75;
  float within = (radius - beside) / pixel;  // pixels from the rim
  if (within <= 0.0) {
    discard;
  }
  float rim = clamp(within, 0.0, 1.0) * clamp(2.2 - within, 0.0, 1.0);
  seen = vec4(paint, mix(kInside, kRim, rim));
  gl_FragDepth = clamp(1.0 + kNear / hit.z, 0.0, 1.0);
}
)";

/// What the vertex shader takes for each sphere.
struct SphereInstance {
  float bounds[4];
  float sphere[4];
  float colour[3];
  float turn[4];
  float surface[2];
};

/// Bounds on the glass, metres from its centre.
struct ImageBounds {
  double left{0.0};
  double right{0.0};
  double bottom{0.0};
  double top{0.0};
};

/// The two tangents from the eye in the plane of one screen direction and the line of sight.
std::pair<double, double> tangents(double across_m, double ahead_m, double radius_m) {
  const double direction = std::atan2(across_m, ahead_m);
  const double half_angle = std::asin(radius_m / std::hypot(across_m, ahead_m));
  return {std::tan(direction - half_angle), std::tan(direction + half_angle)};
}

/// Exact bounds of the perspective image of a sphere with its centre at `p_EC` (as seen from the
/// eye) on a glass `distance_m` away; nothing when it reaches the eye's own plane.
std::optional<ImageBounds> image_bounds(const Vector3& p_EC, double radius_m, double distance_m) {
  const double ahead_m = -p_EC.z();
  if (ahead_m <= radius_m) {
    return std::nullopt;
  }
  const auto [left, right] = tangents(p_EC.x(), ahead_m, radius_m);
  const auto [bottom, top] = tangents(p_EC.y(), ahead_m, radius_m);
  return ImageBounds{left * distance_m, right * distance_m, bottom * distance_m, top * distance_m};
}

/// The spheres that can be seen, farthest first: a blended edge needs what is behind it.
std::vector<SphereInstance> instances_of(const std::vector<ColouredSphere>& spheres,
                                         const Viewer& viewer) {
  /// A sphere to draw, and how far it is.
  struct Seen {
    double distance_m;
    SphereInstance instance;
  };
  std::vector<Seen> seen;
  const Quaternion to_eye(rotation_to_eye(viewer));
  for (const ColouredSphere& each : spheres) {
    const double radius_m = each.sphere.radius_m;
    const Vector3 centre = seen_from_eye(viewer, each.sphere.centre);
    const auto bounds = image_bounds(centre, radius_m, viewer.screen.viewing_distance_m);
    if (!bounds) {
      continue;
    }
    const auto as_float = [](double value) { return static_cast<float>(value); };
    const Eigen::Quaternionf turn = (to_eye * each.orientation).normalized().cast<float>();
    seen.push_back(
        {centre.norm(),
         {{as_float(bounds->left), as_float(bounds->right), as_float(bounds->bottom),
           as_float(bounds->top)},
          {as_float(centre.x()), as_float(centre.y()), as_float(centre.z()), as_float(radius_m)},
          {each.colour[0], each.colour[1], each.colour[2]},
          {turn.x(), turn.y(), turn.z(), turn.w()},
          {each.texture, each.number}}});
  }
  std::stable_sort(seen.begin(), seen.end(), [](const Seen& one, const Seen& other) {
    return one.distance_m > other.distance_m;
  });
  std::vector<SphereInstance> instances;
  instances.reserve(seen.size());
  for (const Seen& sphere : seen) {
    instances.push_back(sphere.instance);
  }
  return instances;
}

}  // namespace

SpherePainter::SpherePainter(BallKind kind)
    : kind_(kind),
      program_(
          {kSphereVertexShader},
          {kLightingShader, kind == BallKind::kSceneLit ? kSceneLightShader : "", kPassingRayShader,
           kind == BallKind::kOpaque     ? kSphereFragmentShader
           : kind == BallKind::kSceneLit ? kSceneLitBallFragmentShader
                                         : kClearBallFragmentShader}) {
  glBindVertexArray(arrangement_);
  glBindBuffer(GL_ARRAY_BUFFER, instances_);
  describe_records(RecordOf::kInstance, sizeof(SphereInstance),
                   {{0, 4, offsetof(SphereInstance, bounds)},
                    {1, 4, offsetof(SphereInstance, sphere)},
                    {2, 3, offsetof(SphereInstance, colour)},
                    {3, 4, offsetof(SphereInstance, turn)},
                    {4, 2, offsetof(SphereInstance, surface)}});
  glBindVertexArray(0);
}

void SpherePainter::paint(const std::vector<ColouredSphere>& spheres, const Viewer& viewer,
                          const PixelArea& area, const SceneLights* lights) {
  glViewport(area.left, area.bottom, area.width, area.height);
  glEnable(GL_SCISSOR_TEST);
  glScissor(area.left, area.bottom, area.width, area.height);
  program_.use(viewer);
  if (lights != nullptr) {
    lights->shine_on(program_);
  }
  glUniform2f(program_.uniform("margin"),
              static_cast<float>(2.0 * viewer.screen.width_m / area.width),
              static_cast<float>(2.0 * viewer.screen.height_m / area.height));
  const std::vector<SphereInstance> instances = instances_of(spheres, viewer);
  glEnable(GL_DEPTH_TEST);
  glDepthMask(kind_ == BallKind::kClear ? GL_FALSE : GL_TRUE);
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  glBindVertexArray(arrangement_);
  fill_buffer(GL_ARRAY_BUFFER, instances_, instances, GL_STREAM_DRAW);
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(instances.size()));
  glBindVertexArray(0);
  glDepthMask(GL_TRUE);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_BLEND);
  glDisable(GL_SCISSOR_TEST);
}

}  // namespace impetus::inline drawing
