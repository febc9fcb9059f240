// SPDX-License-Identifier: MIT
#include "experiments/drawing/volume_painter.hpp"

#include <epoxy/gl.h>

#include <algorithm>
#include <cstddef>

#include "experiments/drawing/lighting_shader.hpp"
#include "experiments/drawing/shader_program.hpp"
#include "experiments/drawing/sphere_image.hpp"
#include "experiments/drawing/volume_shader.hpp"

namespace impetus::inline drawing {
namespace {

/// What the vertex shader takes for each volume.
struct VolumeInstance {
  float place[4];
  float extents[3];
  float turn[4];
  float colour[3];
};

constexpr unsigned kFirstInstanceAttribute = 2;

void describe_volume(unsigned place, int numbers, std::size_t stride, std::size_t offset) {
  glEnableVertexAttribArray(place);
  glVertexAttribPointer(place, numbers, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(stride),
                        reinterpret_cast<const void*>(offset));
  glVertexAttribDivisor(place, place < kFirstInstanceAttribute ? 0 : 1);
}

template <typename T>
void fill_buffer(GLenum kind, unsigned buffer, const std::vector<T>& values, GLenum usage) {
  glBindBuffer(kind, buffer);
  glBufferData(kind, static_cast<GLsizeiptr>(values.size() * sizeof(T)), values.data(), usage);
}

/// Poses are combined in double precision: the card sees only numbers near the eye.
VolumeInstance instance_of(const ColouredVolume& volume, const Viewer& viewer) {
  Matrix3 R_EW;
  R_EW << viewer.right.transpose(), viewer.up.transpose(),
      viewer.right.cross(viewer.up).transpose();
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
    : program_(link_program({kLightingShader, kRoundedBoxVertexShader},
                            {kLightingShader, kRoundedBoxFragmentShader})) {
  glGenBuffers(1, &instances_);
  for (std::size_t fineness = 0; fineness < kParts.size(); ++fineness) {
    meshes_[fineness] = upload(kParts[fineness], instances_);
  }
}

VolumePainter::~VolumePainter() {
  for (const Uploaded& mesh : meshes_) {
    glDeleteBuffers(2, mesh.buffers.data());
    glDeleteVertexArrays(1, &mesh.arrangement);
  }
  glDeleteBuffers(1, &instances_);
  glDeleteProgram(program_);
}

VolumePainter::Uploaded VolumePainter::upload(int parts, unsigned instances) {
  using Vertex = RoundedBoxMesh::Vertex;
  const RoundedBoxMesh ready = rounded_box_mesh(parts);
  Uploaded mesh;
  mesh.indices = static_cast<int>(ready.indices.size());
  glGenVertexArrays(1, &mesh.arrangement);
  glGenBuffers(2, mesh.buffers.data());
  glBindVertexArray(mesh.arrangement);
  fill_buffer(GL_ARRAY_BUFFER, mesh.buffers[0], ready.vertices, GL_STATIC_DRAW);
  fill_buffer(GL_ELEMENT_ARRAY_BUFFER, mesh.buffers[1], ready.indices, GL_STATIC_DRAW);
  describe_volume(0, 3, sizeof(Vertex), offsetof(Vertex, corner));
  describe_volume(1, 3, sizeof(Vertex), offsetof(Vertex, normal));
  glBindBuffer(GL_ARRAY_BUFFER, instances);
  describe_volume(kFirstInstanceAttribute, 4, sizeof(VolumeInstance),
                  offsetof(VolumeInstance, place));
  describe_volume(kFirstInstanceAttribute + 1, 3, sizeof(VolumeInstance),
                  offsetof(VolumeInstance, extents));
  describe_volume(kFirstInstanceAttribute + 2, 4, sizeof(VolumeInstance),
                  offsetof(VolumeInstance, turn));
  describe_volume(kFirstInstanceAttribute + 3, 3, sizeof(VolumeInstance),
                  offsetof(VolumeInstance, colour));
  glBindVertexArray(0);
  return mesh;
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
  glUseProgram(program_);
  glUniform3f(glGetUniformLocation(program_, "glass"), static_cast<float>(screen.width_m),
              static_cast<float>(screen.height_m), static_cast<float>(screen.viewing_distance_m));
  glUniform1f(glGetUniformLocation(program_, "opacity"), opacity);
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
