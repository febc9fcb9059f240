// SPDX-License-Identifier: MIT
#include "experiments/drawing/enclosure_painter.hpp"

#include <epoxy/gl.h>

#include <array>
#include <cmath>
#include <cstddef>

#include "experiments/drawing/enclosure_shader.hpp"
#include "experiments/drawing/lighting_shader.hpp"
#include "experiments/drawing/shader_program.hpp"
#include "experiments/drawing/sphere_image.hpp"

namespace impetus::inline drawing {
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

void describe_corner(unsigned place, int numbers, std::size_t offset) {
  glEnableVertexAttribArray(place);
  glVertexAttribPointer(place, numbers, GL_FLOAT, GL_FALSE, sizeof(Corner),
                        reinterpret_cast<const void*>(offset));
}

Vector3 turned_to_eye(const Viewer& viewer, const Vector3& direction) {
  return {viewer.right.dot(direction), viewer.up.dot(direction),
          viewer.right.cross(viewer.up).dot(direction)};
}

/// The wall's corners in order around it. Corners are numbered by three bits, one for each pair of
/// opposite walls.
std::array<Vector3, 4> corners_of(const Enclosure& enclosure, int wall) {
  const int bit = wall / 2;
  const int across = 1 << (bit + 1) % 3;
  const int along = 1 << (bit + 2) % 3;
  const auto distance = [&](int first) {
    return std::abs(reach_beyond(enclosure, wall, Sphere{corner(enclosure, first), 0.0}));
  };
  const int first = distance(0) < distance(1 << bit) ? 0 : 1 << bit;
  return {corner(enclosure, first), corner(enclosure, first | across),
          corner(enclosure, first | across | along), corner(enclosure, first | along)};
}

/// Two triangles.
void add_wall(const Enclosure& enclosure, int wall, const Viewer& viewer,
              std::vector<Corner>& corners) {
  constexpr std::array<std::size_t, 6> kOrder{0, 1, 2, 0, 2, 3};
  constexpr float kAround[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  const float tone = wall_grey(turned_to_eye(viewer, inward_normal(enclosure, wall)));
  const std::array<Vector3, 4> places = corners_of(enclosure, wall);
  for (const std::size_t place : kOrder) {
    const Eigen::Vector3f seen = seen_from_eye(viewer, places[place]).cast<float>();
    corners.push_back(
        {{seen.x(), seen.y(), seen.z()}, {kAround[place][0], kAround[place][1]}, tone});
  }
}

}  // namespace

std::vector<int> walls_facing(const Enclosure& enclosure, const Vector3& eye) {
  constexpr double kFromTheEdge_m = -1e-9;
  std::vector<int> walls;
  for (int wall = 0; wall < kWallCount; ++wall) {
    if (reach_beyond(enclosure, wall, Sphere{eye, 0.0}) < kFromTheEdge_m) {
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
  describe_corner(0, 3, offsetof(Corner, from_eye));
  describe_corner(1, 2, offsetof(Corner, on_wall));
  describe_corner(2, 1, offsetof(Corner, tone));
  glBindVertexArray(0);
}

EnclosurePainter::~EnclosurePainter() {
  glDeleteBuffers(1, &corners_);
  glDeleteVertexArrays(1, &arrangement_);
  glDeleteProgram(program_);
}

void EnclosurePainter::paint(const Enclosure& enclosure, const Viewer& viewer) {
  std::vector<Corner> corners;
  for (const int wall : walls_facing(enclosure, viewer.eye)) {
    add_wall(enclosure, wall, viewer, corners);
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

}  // namespace impetus::inline drawing
