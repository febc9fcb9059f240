// SPDX-License-Identifier: MIT
#include "experiments/stage/enclosure_painter.hpp"

#include <epoxy/gl.h>

#include <cstddef>

#include "experiments/stage/enclosure_shader.hpp"
#include "experiments/stage/lighting_shader.hpp"
#include "experiments/stage/shader_program.hpp"
#include "experiments/stage/sphere_image.hpp"

namespace impetus {
namespace {

constexpr double kGreyFacing = 0.74;  // of the wall opposite the viewer
constexpr double kGreyUpwards = 0.09;
constexpr double kGreyLeftwards = 0.045;

/// What the vertex shader takes for each corner of a wall.
struct Corner {
  float from_eye[3];
  float on_wall[2];
  float tone;
};

void describe_attribute(unsigned place, int numbers, std::size_t offset) {
  glEnableVertexAttribArray(place);
  glVertexAttribPointer(place, numbers, GL_FLOAT, GL_FALSE, sizeof(Corner),
                        reinterpret_cast<const void*>(offset));
}

Vector3 turned_to_eye(const Viewer& viewer, const Vector3& direction) {
  return {viewer.right.dot(direction), viewer.up.dot(direction),
          viewer.right.cross(viewer.up).dot(direction)};
}

/// Two triangles.
void add_wall(const ClosedCube& cube, int wall, const Viewer& viewer,
              std::vector<Corner>& corners) {
  constexpr double kAround[6][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, -1}, {1, 1}, {-1, 1}};
  const Vector3 normal = inward_normal(wall);
  const float tone = wall_grey(turned_to_eye(viewer, normal));
  const int across = (wall / 2 + 1) % 3;
  const int along = (wall / 2 + 2) % 3;
  for (const auto& [u, v] : kAround) {
    Vector3 corner = -normal;
    corner[across] = u;
    corner[along] = v;
    const Eigen::Vector3f place = seen_from_eye(viewer, cube.half_edge_m * corner).cast<float>();
    corners.push_back(
        {{place.x(), place.y(), place.z()}, {static_cast<float>(u), static_cast<float>(v)}, tone});
  }
}

}  // namespace

std::vector<int> walls_facing(const ClosedCube& cube, const Vector3& eye) {
  std::vector<int> walls;
  for (int wall = 0; wall < kWallCount; ++wall) {
    if (inward_normal(wall).dot(eye) > -cube.half_edge_m) {
      walls.push_back(wall);
    }
  }
  return walls;
}

float wall_grey(const Vector3& normal_E) {
  return static_cast<float>(kGreyFacing + kGreyUpwards * normal_E.y() -
                            kGreyLeftwards * normal_E.x());
}

EnclosurePainter::EnclosurePainter()
    : program_(link_program({kLightingShader, kEnclosureVertexShader}, {kEnclosureFragmentShader})),
      glass_(glGetUniformLocation(program_, "glass")) {
  glGenVertexArrays(1, &arrangement_);
  glGenBuffers(1, &corners_);
  glBindVertexArray(arrangement_);
  glBindBuffer(GL_ARRAY_BUFFER, corners_);
  describe_attribute(0, 3, offsetof(Corner, from_eye));
  describe_attribute(1, 2, offsetof(Corner, on_wall));
  describe_attribute(2, 1, offsetof(Corner, tone));
  glBindVertexArray(0);
}

EnclosurePainter::~EnclosurePainter() {
  glDeleteBuffers(1, &corners_);
  glDeleteVertexArrays(1, &arrangement_);
  glDeleteProgram(program_);
}

void EnclosurePainter::paint(const ClosedCube& cube, const Viewer& viewer) {
  std::vector<Corner> corners;
  for (const int wall : walls_facing(cube, viewer.eye)) {
    add_wall(cube, wall, viewer, corners);
  }
  const ScreenGeometry& screen = viewer.screen;
  glUseProgram(program_);
  glUniform3f(glass_, static_cast<float>(screen.width_m), static_cast<float>(screen.height_m),
              static_cast<float>(screen.viewing_distance_m));
  glEnable(GL_DEPTH_TEST);
  glBindVertexArray(arrangement_);
  glBindBuffer(GL_ARRAY_BUFFER, corners_);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(corners.size() * sizeof(Corner)),
               corners.data(), GL_STREAM_DRAW);
  glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(corners.size()));
  glBindVertexArray(0);
  glDisable(GL_DEPTH_TEST);
}

}  // namespace impetus
