// SPDX-License-Identifier: MIT
#include "experiments/drawing/volume_painter.hpp"

#include <algorithm>
#include <cstddef>

#include "experiments/drawing/gl.hpp"
#include "experiments/drawing/picture_map.hpp"

namespace impetus::inline drawing {
namespace {

/// A volume of any kind as a rounded box, in the perspective and the depth of the ray-cast spheres.
/// Follows kLightingShader; lengths in metres, the eye at the origin.
constexpr const char* kRoundedBoxVertexShader = R"(
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
constexpr const char* kRoundedBoxFragmentShader = R"(
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

/// What the vertex shader takes for each volume.
struct VolumeInstance {
  float place[4];
  float extents[3];
  float turn[4];
  float colour[3];
};

/// Poses are combined in double precision: the card sees only numbers near the eye.
VolumeInstance instance_of(const ColouredVolume& volume, const Viewer& viewer) {
  const Matrix3 R_EW = rotation_to_eye(viewer);
  const RoundedBox& shape = volume.shape;
  const Eigen::Vector3f place = seen_from_eye(viewer, shape.centre).cast<float>();
  const Eigen::Vector3f extents = shape.half_extents_m.cast<float>();
  const Eigen::Quaternionf turn = Quaternion(Matrix3(R_EW * shape.axes)).normalized().cast<float>();
  return {{place.x(), place.y(), place.z(), static_cast<float>(shape.radius_m)},
          {extents.x(), extents.y(), extents.z()},
          {turn.x(), turn.y(), turn.z(), turn.w()},
          {volume.colour[0], volume.colour[1], volume.colour[2]}};
}

/// The coarsest mesh that is within half a pixel of the rounding, by its radius in pixels.
std::size_t fineness_of(const VolumeInstance& instance, float px_at_a_metre) {
  const float ahead = std::max(-instance.place[2], 1e-6F);
  const float radius_px = instance.place[3] * px_at_a_metre / ahead;
  return radius_px <= 0.0F   ? 0
         : radius_px < 5.0F  ? 1
         : radius_px < 20.0F ? 2
         : radius_px < 70.0F ? 3
                             : 4;
}

}  // namespace

VolumePainter::VolumePainter()
    : program_({kLightingShader, kRoundedBoxVertexShader},
               {kLightingShader, kRoundedBoxFragmentShader}) {
  for (std::size_t fineness = 0; fineness < kParts.size(); ++fineness) {
    upload(kParts[fineness], meshes_[fineness]);
  }
}

void VolumePainter::upload(int parts, Uploaded& mesh) const {
  using Vertex = RoundedBoxMesh::Vertex;
  const RoundedBoxMesh ready = rounded_box_mesh(parts);
  mesh.indices = static_cast<int>(ready.indices.size());
  glBindVertexArray(mesh.arrangement);
  fill_buffer(GL_ARRAY_BUFFER, mesh.vertices, ready.vertices, GL_STATIC_DRAW);
  fill_buffer(GL_ELEMENT_ARRAY_BUFFER, mesh.corners, ready.indices, GL_STATIC_DRAW);
  describe_records(RecordOf::kVertex, sizeof(Vertex),
                   {{0, 3, offsetof(Vertex, corner)}, {1, 3, offsetof(Vertex, normal)}});
  glBindBuffer(GL_ARRAY_BUFFER, instances_);
  describe_records(RecordOf::kInstance, sizeof(VolumeInstance),
                   {{2, 4, offsetof(VolumeInstance, place)},
                    {3, 3, offsetof(VolumeInstance, extents)},
                    {4, 4, offsetof(VolumeInstance, turn)},
                    {5, 3, offsetof(VolumeInstance, colour)}});
  glBindVertexArray(0);
}

void VolumePainter::paint(const std::vector<ColouredVolume>& volumes, const Viewer& viewer,
                          int height_px, float opacity) {
  const ScreenGeometry& screen = viewer.screen;
  const auto px_at_a_metre =
      static_cast<float>(height_px * screen.viewing_distance_m / screen.height_m);
  std::array<std::vector<VolumeInstance>, kParts.size()> by_fineness;
  for (const ColouredVolume& volume : volumes) {
    const VolumeInstance instance = instance_of(volume, viewer);
    by_fineness[fineness_of(instance, px_at_a_metre)].push_back(instance);
  }
  const auto draw = [&] {
    for (std::size_t fineness = 0; fineness < kParts.size(); ++fineness) {
      const std::vector<VolumeInstance>& instances = by_fineness[fineness];
      glBindVertexArray(meshes_[fineness].arrangement);
      fill_buffer(GL_ARRAY_BUFFER, instances_, instances, GL_STREAM_DRAW);
      glDrawElementsInstanced(GL_TRIANGLES, meshes_[fineness].indices, GL_UNSIGNED_INT, nullptr,
                              static_cast<GLsizei>(instances.size()));
    }
  };
  program_.use(viewer);
  glUniform1f(program_.uniform("opacity"), opacity);
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_CULL_FACE);
  if (opacity < 1.0F) {
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    draw();
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthFunc(GL_EQUAL);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  }
  draw();
  glDepthFunc(GL_LESS);
  glDisable(GL_BLEND);
  glBindVertexArray(0);
  glDisable(GL_CULL_FACE);
  glDisable(GL_DEPTH_TEST);
}

}  // namespace impetus::inline drawing
