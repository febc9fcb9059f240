// SPDX-License-Identifier: MIT
#include "experiments/stage/mesh_painter.hpp"

#include <epoxy/gl.h>

#include <cstddef>

#include "experiments/stage/lighting_shader.hpp"
#include "experiments/stage/mesh_shader.hpp"
#include "experiments/stage/shaded_mesh.hpp"
#include "experiments/stage/shader_program.hpp"
#include "experiments/stage/sphere_image.hpp"

namespace impetus {
namespace {

template <typename T>
void fill_buffer(GLenum kind, unsigned buffer, const std::vector<T>& values) {
  glBindBuffer(kind, buffer);
  glBufferData(kind, static_cast<GLsizeiptr>(values.size() * sizeof(T)), values.data(),
               GL_STATIC_DRAW);
}

void describe_attribute(unsigned place, std::size_t offset) {
  glEnableVertexAttribArray(place);
  glVertexAttribPointer(place, 3, GL_FLOAT, GL_FALSE, sizeof(ShadedVertex),
                        reinterpret_cast<const void*>(offset));
}

}  // namespace

/// One mesh on the graphics card. While its owner lasts, no other mesh can have its address.
struct MeshPainter::Uploaded {
  explicit Uploaded(const std::shared_ptr<const TriangleMesh>& mesh) : owner(mesh) {
    const ShadedMesh ready = shaded(*mesh);
    indices = static_cast<int>(ready.indices.size());
    glGenVertexArrays(1, &arrangement);
    glGenBuffers(2, buffers);
    glBindVertexArray(arrangement);
    fill_buffer(GL_ARRAY_BUFFER, buffers[0], ready.vertices);
    fill_buffer(GL_ELEMENT_ARRAY_BUFFER, buffers[1], ready.indices);
    describe_attribute(0, offsetof(ShadedVertex, position));
    describe_attribute(1, offsetof(ShadedVertex, normal));
    glBindVertexArray(0);
  }
  ~Uploaded() {
    glDeleteBuffers(2, buffers);
    glDeleteVertexArrays(1, &arrangement);
  }
  Uploaded(const Uploaded&) = delete;
  Uploaded& operator=(const Uploaded&) = delete;

  std::weak_ptr<const TriangleMesh> owner;
  unsigned arrangement{0};
  unsigned buffers[2]{};
  int indices{0};
};

MeshPainter::MeshPainter()
    : program_(link_program({kLightingShader, kMeshVertexShader},
                            {kLightingShader, kMeshFragmentShader})),
      glass_(glGetUniformLocation(program_, "glass")),
      turn_(glGetUniformLocation(program_, "turn")),
      place_(glGetUniformLocation(program_, "place")),
      colour_(glGetUniformLocation(program_, "colour")) {}

MeshPainter::~MeshPainter() { glDeleteProgram(program_); }

void MeshPainter::forget_ended() {
  std::erase_if(meshes_, [](const auto& entry) { return entry.second->owner.expired(); });
}

const MeshPainter::Uploaded& MeshPainter::uploaded(
    const std::shared_ptr<const TriangleMesh>& mesh) {
  std::unique_ptr<Uploaded>& place = meshes_[mesh.get()];
  if (!place) {
    place = std::make_unique<Uploaded>(mesh);
  }
  return *place;
}

void MeshPainter::paint(const Picture& picture) {
  forget_ended();
  const ScreenGeometry& screen = picture.viewer.screen;
  glUseProgram(program_);
  glUniform3f(glass_, static_cast<float>(screen.width_m), static_cast<float>(screen.height_m),
              static_cast<float>(screen.viewing_distance_m));
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_CULL_FACE);
  for (const PosedBody& body : picture.bodies) {
    if (body.look.mesh) {
      paint_body(picture.viewer, body);
    }
  }
  glBindVertexArray(0);
  glDisable(GL_CULL_FACE);
  glDisable(GL_DEPTH_TEST);
}

// Poses are combined in double precision: the card sees only numbers near the eye.
void MeshPainter::paint_body(const Viewer& viewer, const PosedBody& body) {
  Matrix3 R_EW;
  R_EW << viewer.right.transpose(), viewer.up.transpose(),
      viewer.right.cross(viewer.up).transpose();
  const Eigen::Matrix3f turn =
      (R_EW * body.pose.orientation.normalized().toRotationMatrix()).cast<float>();
  const Eigen::Vector3f place = seen_from_eye(viewer, body.pose.position).cast<float>();
  const Uploaded& mesh = uploaded(body.look.mesh);
  glUniformMatrix3fv(turn_, 1, GL_FALSE, turn.data());
  glUniform3fv(place_, 1, place.data());
  glUniform3fv(colour_, 1, body.look.colour.data());
  glBindVertexArray(mesh.arrangement);
  glDrawElements(GL_TRIANGLES, mesh.indices, GL_UNSIGNED_INT, nullptr);
}

}  // namespace impetus
