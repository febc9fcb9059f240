// SPDX-License-Identifier: MIT
#include "experiments/drawing/crowd_painter.hpp"

#include <epoxy/gl.h>

#include <algorithm>
#include <cstddef>
#include <utility>

#include "experiments/drawing/crowd_shader.hpp"
#include "experiments/drawing/lighting_shader.hpp"
#include "experiments/drawing/shader_program.hpp"
#include "experiments/drawing/sphere_image.hpp"

namespace impetus::inline drawing {
namespace {

constexpr unsigned kPlace = 2;
constexpr unsigned kTurn = 3;
constexpr unsigned kColour = 4;

/// Where few triangles stand for a round surface, they meet at greater angles.
constexpr double kHardCoarseEdgeDeg = 60.0;

struct SeenBody {
  const PosedBody* body{nullptr};
  Vector3 from_eye{Vector3::Zero()};

  /// Along the line of sight; never behind the eye's own plane.
  [[nodiscard]] double ahead_m() const { return std::max(-from_eye.z(), 1e-6); }
};

std::vector<SeenBody> nearest_first(const Picture& picture) {
  std::vector<SeenBody> bodies;
  for (const PosedBody& body : picture.bodies) {
    if (body.look.mesh) {
      bodies.push_back({&body, seen_from_eye(picture.viewer, body.pose.position)});
    }
  }
  std::stable_sort(bodies.begin(), bodies.end(), [](const SeenBody& one, const SeenBody& other) {
    return one.ahead_m() < other.ahead_m();
  });
  return bodies;
}

Matrix3 rotation_to_eye(const Viewer& viewer) {
  Matrix3 R_EW;
  R_EW << viewer.right.transpose(), viewer.up.transpose(),
      viewer.right.cross(viewer.up).transpose();
  return R_EW;
}

}  // namespace

CrowdPainter::CrowdPainter()
    : program_(link_program({kLightingShader, kCrowdVertexShader}, {kCrowdFragmentShader})),
      glass_(glGetUniformLocation(program_, "glass")),
      meshes_([this] { describe_instances(); }) {
  glGenBuffers(1, &instances_);
}

CrowdPainter::~CrowdPainter() {
  glDeleteBuffers(1, &instances_);
  glDeleteProgram(program_);
}

void CrowdPainter::describe_instances() const {
  const auto describe = [](unsigned place, int numbers, std::size_t offset) {
    glEnableVertexAttribArray(place);
    glVertexAttribPointer(place, numbers, GL_FLOAT, GL_FALSE, sizeof(Instance),
                          reinterpret_cast<const void*>(offset));
    glVertexAttribDivisor(place, 1);
  };
  glBindBuffer(GL_ARRAY_BUFFER, instances_);
  describe(kPlace, 3, offsetof(Instance, place));
  describe(kTurn, 4, offsetof(Instance, turn));
  describe(kColour, 3, offsetof(Instance, colour));
}

// Poses are combined in double precision: the card sees only numbers near the eye.
void CrowdPainter::sort(const Picture& picture, int height_px) {
  const ScreenGeometry& screen = picture.viewer.screen;
  const double px_at_a_metre = height_px * screen.viewing_distance_m / screen.height_m;
  const Quaternion to_eye(rotation_to_eye(picture.viewer));
  groups_.clear();
  group_of_.clear();
  for (const SeenBody& seen : nearest_first(picture)) {
    const DrawnBody& look = seen.body->look;
    const double nearest_m = std::max(seen.ahead_m() - look.radius_m, 1e-6);
    const auto& chosen = mesh_as_seen(look.mesh, look.coarser.get(), px_at_a_metre / nearest_m);
    const UploadedMesh& mesh =
        meshes_.of(chosen, chosen == look.mesh ? kHardEdgeDeg : kHardCoarseEdgeDeg);
    const auto [place, is_new] = group_of_.try_emplace(mesh.arrangement, groups_.size());
    if (is_new) {
      groups_.push_back({&mesh, {}});
    }
    const Eigen::Vector3f at = seen.from_eye.cast<float>();
    const Eigen::Quaternionf turn =
        (to_eye * seen.body->pose.orientation).normalized().cast<float>();
    groups_[place->second].instances.push_back({{at.x(), at.y(), at.z()},
                                                {turn.x(), turn.y(), turn.z(), turn.w()},
                                                {look.colour[0], look.colour[1], look.colour[2]}});
  }
}

void CrowdPainter::paint(const Picture& picture, int height_px) {
  meshes_.forget_ended();
  sort(picture, height_px);
  const ScreenGeometry& screen = picture.viewer.screen;
  glUseProgram(program_);
  glUniform3f(glass_, static_cast<float>(screen.width_m), static_cast<float>(screen.height_m),
              static_cast<float>(screen.viewing_distance_m));
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_CULL_FACE);
  for (const Alike& alike : groups_) {
    glBindVertexArray(alike.mesh->arrangement);
    glBindBuffer(GL_ARRAY_BUFFER, instances_);
    glBufferData(GL_ARRAY_BUFFER,
                 static_cast<GLsizeiptr>(alike.instances.size() * sizeof(Instance)),
                 alike.instances.data(), GL_STREAM_DRAW);
    glDrawElementsInstanced(GL_TRIANGLES, alike.mesh->indices, GL_UNSIGNED_INT, nullptr,
                            static_cast<GLsizei>(alike.instances.size()));
  }
  glBindVertexArray(0);
  glDisable(GL_CULL_FACE);
  glDisable(GL_DEPTH_TEST);
}

}  // namespace impetus::inline drawing
