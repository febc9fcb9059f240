// SPDX-License-Identifier: MIT
#include "experiments/drawing/mesh_painter.hpp"

#include <epoxy/gl.h>

#include "experiments/drawing/lighting_shader.hpp"
#include "experiments/drawing/mesh_shader.hpp"
#include "experiments/drawing/shader_program.hpp"
#include "experiments/drawing/sphere_image.hpp"

namespace impetus::inline drawing {

MeshPainter::MeshPainter()
    : program_(link_program({kLightingShader, kMeshVertexShader},
                            {kLightingShader, kMeshFragmentShader})),
      glass_(glGetUniformLocation(program_, "glass")),
      turn_(glGetUniformLocation(program_, "turn")),
      place_(glGetUniformLocation(program_, "place")),
      colour_(glGetUniformLocation(program_, "colour")) {}

MeshPainter::~MeshPainter() { glDeleteProgram(program_); }

void MeshPainter::paint(const Picture& picture) {
  meshes_.forget_ended();
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
  const UploadedMesh& mesh = meshes_.of(body.look.mesh);
  glUniformMatrix3fv(turn_, 1, GL_FALSE, turn.data());
  glUniform3fv(place_, 1, place.data());
  glUniform3fv(colour_, 1, body.look.colour.data());
  glBindVertexArray(mesh.arrangement);
  glDrawElements(GL_TRIANGLES, mesh.indices, GL_UNSIGNED_INT, nullptr);
}

}  // namespace impetus::inline drawing
