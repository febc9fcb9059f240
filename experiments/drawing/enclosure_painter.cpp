// SPDX-License-Identifier: MIT
#include "experiments/drawing/enclosure_painter.hpp"

#include <array>
#include <cmath>
#include <cstddef>

#include "experiments/drawing/gl.hpp"
#include "experiments/drawing/picture_map.hpp"

namespace impetus::inline drawing {
namespace {

/// Of a wall: one tone, and a thin line along its edges. Follows kLightingShader; lengths in
/// metres, the eye at the origin. The perspective and the depth are those of the meshes.
constexpr const char* kEnclosureVertexShader = R"(
layout(location = 0) in vec3 from_eye;
layout(location = 1) in vec2 on_wall;  // ±1 at the wall's edges
layout(location = 2) in float tone;    // sRGB
layout(location = 3) in vec3 inward;   // unit
uniform vec3 glass;                    // width, height, distance
out vec2 across;
out vec3 place;
flat out float grey;
flat out vec3 normal;

void main() {
  across = on_wall;
  place = from_eye;
  grey = tone;
  normal = inward;
  float ahead = -from_eye.z;
  gl_Position = vec4(2.0 * glass.z * from_eye.xy / glass.xy, ahead - 2.0 * kNear, ahead);
}
)";

constexpr const char* kWallShader = R"(
const float kHalfLine = 1.0;  // pixels: two walls share an edge
const float kLineGrey = 0.40;
in vec2 across;
in vec3 place;
flat in float grey;
flat in vec3 normal;
out vec4 seen;

void main() {
  vec2 pixels = (1.0 - abs(across)) / max(fwidth(across), vec2(1e-6));
  float line = clamp(kHalfLine + 0.5 - min(pixels.x, pixels.y), 0.0, 1.0);
  vec3 own = vec3(mix(grey, kLineGrey, line));
)";

/// Follows kWallShader.
constexpr const char* kWallAsItIsShader = R"(
  seen = vec4(own, 1.0);
}
)";

/// Follows kSceneLightShader and kWallShader.
constexpr const char* kSceneLitWallShader = R"(
  seen = vec4(lit_wall(place, normal, own), 1.0);
}
)";

constexpr double kGreyFacing = 0.74;  // of the wall opposite the viewer
constexpr double kGreyUpwards = 0.09;
constexpr double kGreyLeftwards = 0.045;

/// What the vertex shader takes for each corner of a wall.
struct Corner {
  float from_eye[3];
  float on_wall[2];
  float tone;
  float inward[3];
};

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
  const Vector3 inward = seen_direction(viewer, inward_normal(enclosure, wall));
  const Eigen::Vector3f normal = inward.cast<float>();
  const float tone = wall_grey(inward);
  const std::array<Vector3, 4> places = corners_of(enclosure, wall);
  for (const std::size_t place : kOrder) {
    const Eigen::Vector3f seen = seen_from_eye(viewer, places[place]).cast<float>();
    corners.push_back({{seen.x(), seen.y(), seen.z()},
                       {kAround[place][0], kAround[place][1]},
                       tone,
                       {normal.x(), normal.y(), normal.z()}});
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

EnclosurePainter::EnclosurePainter(LitBy light)
    : program_({kLightingShader, kEnclosureVertexShader},
               {kLightingShader, light == LitBy::kSceneLights ? kSceneLightShader : "", kWallShader,
                light == LitBy::kSceneLights ? kSceneLitWallShader : kWallAsItIsShader}) {
  glBindVertexArray(arrangement_);
  glBindBuffer(GL_ARRAY_BUFFER, corners_);
  describe_records(RecordOf::kVertex, sizeof(Corner),
                   {{0, 3, offsetof(Corner, from_eye)},
                    {1, 2, offsetof(Corner, on_wall)},
                    {2, 1, offsetof(Corner, tone)},
                    {3, 3, offsetof(Corner, inward)}});
  glBindVertexArray(0);
}

void EnclosurePainter::paint(const Enclosure& enclosure, const Viewer& viewer,
                             const SceneLights* lights) {
  std::vector<Corner> corners;
  for (const int wall : walls_facing(enclosure, viewer.eye)) {
    add_wall(enclosure, wall, viewer, corners);
  }
  program_.use(viewer);
  if (lights != nullptr) {
    lights->shine_on(program_);
  }
  glEnable(GL_DEPTH_TEST);
  glBindVertexArray(arrangement_);
  fill_buffer(GL_ARRAY_BUFFER, corners_, corners, GL_STREAM_DRAW);
  glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(corners.size()));
  glBindVertexArray(0);
  glDisable(GL_DEPTH_TEST);
}

}  // namespace impetus::inline drawing
