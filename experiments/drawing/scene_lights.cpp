// SPDX-License-Identifier: MIT
#include "experiments/drawing/scene_lights.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "experiments/drawing/gl.hpp"
#include "experiments/drawing/picture_map.hpp"

namespace impetus::inline drawing {
namespace {

constexpr int kMapSide_px = 1536;
constexpr int kFloorMapSide_px = 1024;

/// The deviation of the blur of contact shadows, in their reach.
constexpr double kBlurShare = 0.4;

/// Beyond a body's ball: what softens a shadow reaches no further.
constexpr double kPartMargin_m = 0.004;

constexpr const char* kCasterVertexShader = R"(
layout(location = 0) in vec3 vertex;  // in the body's frame
layout(location = 2) in vec3 place;   // of the body, from the eye
layout(location = 3) in vec4 turn;    // from the body's frame to the viewer's, a unit quaternion
layout(location = 6) in float size;
uniform mat4 to_this_map;

vec3 turned(vec3 v) {
  return v + 2.0 * cross(turn.xyz, cross(turn.xyz, v) + turn.w * v);
}

void main() {
  vec3 at = (to_this_map * vec4(turned(size * vertex) + place, 1.0)).xyz;
  gl_Position = vec4(2.0 * at - 1.0, 1.0);
}
)";

constexpr const char* kDepthOnlyShader = R"(
void main() {}
)";

/// One triangle that covers all.
constexpr const char* kCoveringVertexShader = R"(
out vec2 at;
void main() {
  at = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0;
  gl_Position = vec4(2.0 * at - 1.0, 0.0, 1.0);
}
)";

/// A Gaussian in one direction, to two and a half of its deviations.
constexpr const char* kBlurFragmentShader = R"(
const int kHalf = 5;  // looks to either side, half a deviation apart
in vec2 at;
uniform sampler2D source;
uniform vec2 apart;
uniform bool from_depths;  // or from what is half blurred
out float closed;

void main() {
  float sum = 0.0;
  float weights = 0.0;
  for (int i = -kHalf; i <= kHalf; ++i) {
    float weight = exp(-0.125 * float(i * i));
    float value = texture(source, at + float(i) * apart).r;
    sum += weight * (from_depths ? (1.0 - value) * (1.0 - value) : value);
    weights += weight;
  }
  closed = sum / weights;
}
)";

void keep_within(GLenum kind, unsigned texture, GLenum filter) {
  glBindTexture(kind, texture);
  glTexParameteri(kind, GL_TEXTURE_MIN_FILTER, static_cast<GLint>(filter));
  glTexParameteri(kind, GL_TEXTURE_MAG_FILTER, static_cast<GLint>(filter));
  glTexParameteri(kind, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(kind, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

/// Room for one of the floor's maps.
void reserve_flat(unsigned texture, GLenum format, GLenum channels) {
  keep_within(GL_TEXTURE_2D, texture, GL_LINEAR);
  glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format), kFloorMapSide_px, kFloorMapSide_px, 0,
               channels, GL_FLOAT, nullptr);
}

/// The rows are two axes of a map and the way away from what looks at it.
struct MapAxes {
  Vector3 right;
  Vector3 up;
  Vector3 ahead;
};

MapAxes axes_along(const Vector3& ahead) {
  const Vector3 aside =
      std::abs(ahead.y()) < 0.99 ? Vector3(Vector3::UnitY()) : Vector3(Vector3::UnitX());
  const Vector3 right = ahead.cross(aside).normalized();
  return {right, right.cross(ahead), ahead};
}

/// From places as seen from the eye to a map whose middle is `middle` (world), with half a side of
/// `reach_m`; in depth, from 0 to 1 between `begin_m` and `end_m` ahead of the middle.
Eigen::Matrix4f map_from_eye(const Viewer& viewer, const MapAxes& axes, const Vector3& middle,
                             double reach_m, double begin_m, double end_m) {
  Matrix3 R_MW;
  R_MW << axes.right.transpose() / (2.0 * reach_m), axes.up.transpose() / (2.0 * reach_m),
      axes.ahead.transpose() / (end_m - begin_m);
  const Vector3 start(0.5, 0.5, -begin_m / (end_m - begin_m));
  Eigen::Matrix4d map = Eigen::Matrix4d::Identity();
  map.topLeftCorner<3, 3>() = R_MW * rotation_to_eye(viewer).transpose();
  map.topRightCorner<3, 1>() = R_MW * (viewer.eye - middle) + start;
  return map.cast<float>();
}

/// The part of a map, half of whose side is `reach_m`, on which there are bodies that come within
/// the `depth_m` of its depth.
Eigen::AlignedBox2f part_with_bodies(const Picture& picture, const Eigen::Matrix4f& from_eye,
                                     double reach_m, double depth_m) {
  Eigen::AlignedBox2f part;
  for (const PosedBody& body : picture.bodies) {
    const Eigen::Vector3f seen = seen_from_eye(picture.viewer, body.pose.position).cast<float>();
    const Eigen::Vector3f at = (from_eye * seen.homogeneous()).head<3>();
    if (at.z() - body.look.radius_m / depth_m > 1.0) {
      continue;
    }
    const auto half = static_cast<float>((body.look.radius_m + kPartMargin_m) / (2.0 * reach_m));
    part.extend(Eigen::Vector2f(at.x() - half, at.y() - half));
    part.extend(Eigen::Vector2f(at.x() + half, at.y() + half));
  }
  return part;
}

void set_matrix(const ShaderProgram& program, const char* name, const Eigen::Matrix4f& matrix) {
  glUniformMatrix4fv(program.uniform(name), 1, GL_FALSE, matrix.data());
}

std::string element(const char* name, std::size_t index) {
  return std::string(name) + "[" + std::to_string(index) + "]";
}

}  // namespace

float texture_number(const Picture& picture, const DrawnBody& look) {
  const SurfaceTexture usual =
      picture.appearance ? picture.appearance->texture : SurfaceTexture::kNone;
  return static_cast<float>(look.texture.value_or(usual));
}

SceneLights::SceneLights()
    : caster_({kCasterVertexShader}, {kDepthOnlyShader}),
      blur_({kCoveringVertexShader}, {kBlurFragmentShader}) {}

void SceneLights::reserve_maps(std::size_t lights) {
  if (lights <= layers_) {
    return;
  }
  layers_ = lights;
  keep_within(GL_TEXTURE_2D_ARRAY, maps_, GL_LINEAR);
  glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_DEPTH_COMPONENT24, kMapSide_px, kMapSide_px,
               static_cast<GLsizei>(lights), 0, GL_DEPTH_COMPONENT, GL_FLOAT, nullptr);
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  reserve_flat(floor_map_, GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT);
  reserve_flat(half_blurred_, kGreyFormat, GL_RED);
  reserve_flat(closed_, kGreyFormat, GL_RED);
}

void SceneLights::draw_depths(const MapView& view, int side_px,
                              const std::function<void()>& draw_bodies) const {
  draw_to(GL_NONE);
  glReadBuffer(GL_NONE);
  glViewport(0, 0, side_px, side_px);
  glClear(GL_DEPTH_BUFFER_BIT);
  caster_.use(viewer_);
  set_matrix(caster_, "to_this_map", view.from_eye);
  glEnable(GL_DEPTH_TEST);
  clamp_depths(true);  // what is nearer than a map begins is in the way all the same
  draw_bodies();
  clamp_depths(false);
  glDisable(GL_DEPTH_TEST);
}

void SceneLights::cast(const Picture& picture, const std::function<void()>& draw_bodies) {
  const double reach_m = appearance_.shadow_reach_m;
  glBindFramebuffer(GL_FRAMEBUFFER, depths_);
  glEnable(GL_CULL_FACE);
  glCullFace(GL_FRONT);
  for (std::size_t i = 0; i < appearance_.lights.size(); ++i) {
    MapView& view = views_[i];
    view.from_eye = map_from_eye(viewer_, axes_along(-appearance_.lights[i].towards),
                                 Vector3::Zero(), reach_m, -reach_m, reach_m);
    view.bodies = part_with_bodies(picture, view.from_eye, reach_m, 2.0 * reach_m);
    glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, maps_, 0, static_cast<int>(i));
    draw_depths(view, kMapSide_px, draw_bodies);
  }
  glCullFace(GL_BACK);
  glDisable(GL_CULL_FACE);
}

void SceneLights::touch(const Picture& picture, const std::function<void()>& draw_bodies) {
  const double reach_m = appearance_.shadow_reach_m;
  const double height_m = appearance_.contact_reach_m;
  floor_.from_eye = map_from_eye(viewer_, axes_along(Vector3::UnitY()),
                                 *appearance_.floor_m * Vector3::UnitY(), reach_m, 0.0, height_m);
  floor_.bodies = part_with_bodies(picture, floor_.from_eye, reach_m, height_m);
  glBindFramebuffer(GL_FRAMEBUFFER, depths_);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, floor_map_, 0);
  draw_depths(floor_, kFloorMapSide_px, draw_bodies);
  blur_floor();
}

// Across, then along: what is blurred once is the source of the second time.
void SceneLights::blur_floor() const {
  const double deviation = kBlurShare * appearance_.contact_reach_m;
  const auto apart = static_cast<float>(0.5 * deviation / (2.0 * appearance_.shadow_reach_m));
  glBindFramebuffer(GL_FRAMEBUFFER, blurs_);
  draw_to(GL_COLOR_ATTACHMENT0);
  glClearColor(0.0F, 0.0F, 0.0F, 0.0F);
  blur_.use(viewer_);
  glUniform1i(blur_.uniform("source"), 0);
  glActiveTexture(GL_TEXTURE0);
  glBindVertexArray(nothing_);
  for (const bool is_first : {true, false}) {
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D,
                           is_first ? half_blurred_ : closed_, 0);
    glClear(GL_COLOR_BUFFER_BIT);
    if (floor_.bodies.isEmpty()) {
      continue;
    }
    const Eigen::Vector2f margin = Eigen::Vector2f::Constant(6.0F * apart);
    const Eigen::Vector2f low = kFloorMapSide_px * (floor_.bodies.min() - margin);
    const Eigen::Vector2f size = kFloorMapSide_px * (floor_.bodies.sizes() + 2.0F * margin);
    glEnable(GL_SCISSOR_TEST);
    glScissor(static_cast<int>(std::floor(low.x())), static_cast<int>(std::floor(low.y())),
              static_cast<int>(std::ceil(size.x())) + 1, static_cast<int>(std::ceil(size.y())) + 1);
    glBindTexture(GL_TEXTURE_2D, is_first ? floor_map_ : half_blurred_);
    glUniform2f(blur_.uniform("apart"), is_first ? apart : 0.0F, is_first ? 0.0F : apart);
    glUniform1i(blur_.uniform("from_depths"), is_first ? 1 : 0);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDisable(GL_SCISSOR_TEST);
  }
  glBindVertexArray(0);
}

void SceneLights::prepare(const Picture& picture, const std::function<void()>& draw_bodies) {
  viewer_ = picture.viewer;
  appearance_ = *picture.appearance;
  reserve_maps(std::max<std::size_t>(1, appearance_.lights.size()));
  views_ = {};
  floor_ = {};
  if (appearance_.cast_shadows > 0.0) {
    cast(picture, draw_bodies);
  }
  if (appearance_.contact_shadows > 0.0 && appearance_.floor_m) {
    touch(picture, draw_bodies);
  }
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

void SceneLights::shine_on(const ShaderProgram& program) const {
  const auto set = [&](const std::string& name, double value) {
    glUniform1f(program.uniform(name.c_str()), static_cast<float>(value));
  };
  const auto set_direction = [&](const std::string& name, const Vector3& world) {
    const Eigen::Vector3f seen = seen_direction(viewer_, world).cast<float>();
    glUniform3fv(program.uniform(name.c_str()), 1, seen.data());
  };
  const double map_side_m = 2.0 * appearance_.shadow_reach_m;
  set_direction("world_up", Vector3::UnitY());
  glUniform1i(program.uniform("light_count"), static_cast<int>(appearance_.lights.size()));
  for (std::size_t i = 0; i < appearance_.lights.size(); ++i) {
    const Eigen::AlignedBox2f& part = views_[i].bodies;
    set_direction(element("lights", i), appearance_.lights[i].towards);
    set(element("strengths", i), appearance_.lights[i].strength);
    set_matrix(program, element("to_map", i).c_str(), views_[i].from_eye);
    glUniform4f(program.uniform(element("shaded", i).c_str()), part.min().x(), part.min().y(),
                part.max().x(), part.max().y());
  }
  set("look_apart", 1.0 / kMapSide_px);  // further apart, the looks would be seen one by one
  set("off_surface", map_side_m / kMapSide_px);
  set("cast_share", appearance_.cast_shadows);
  set("gloss_share", appearance_.gloss);
  set_matrix(program, "to_floor", floor_.from_eye);
  set("contact_share", floor_.bodies.isEmpty() ? 0.0 : appearance_.contact_shadows);
  glUniform1i(program.uniform("maps"), 0);
  glUniform1i(program.uniform("closed"), 1);
  glActiveTexture(GL_TEXTURE1);
  glBindTexture(GL_TEXTURE_2D, closed_);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D_ARRAY, maps_);
}

}  // namespace impetus::inline drawing
