// SPDX-License-Identifier: MIT
#include "engine/shapes/solids/ring_meshes.hpp"

#include <cassert>
#include <utility>

#include "engine/numerics/elementary_functions.hpp"

namespace impetus::inline shapes {
namespace {

/// The small circle's share of the large one's radius: near the value that leaves most room.
constexpr double kSmallCircle = 0.45;
constexpr double kUntwistingTurns = 3.0;

/// A point of the curve and two unit vectors normal to it; across × beside points along it.
struct Station {
  Vector3 place;
  Vector3 across;
  Vector3 beside;
};

Station station_at(double radius_m, double turn) {
  const double large_m = radius_m / (1.0 + kSmallCircle);
  const double small_m = kSmallCircle * large_m;
  const auto [sin_round, cos_round] = sine_cosine_deg(2.0 * 360.0 * turn);
  const auto [sin_tube, cos_tube] = sine_cosine_deg(3.0 * 360.0 * turn);
  const Vector3 outward(cos_round, sin_round, 0.0);
  const Vector3 onward(-sin_round, cos_round, 0.0);
  const double from_axis_m = large_m + small_m * cos_tube;
  const Vector3 along = 2.0 * from_axis_m * onward - 3.0 * small_m * sin_tube * outward +
                        3.0 * small_m * cos_tube * Vector3::UnitZ();
  const Vector3 across = cos_tube * outward + sin_tube * Vector3::UnitZ();
  return {from_axis_m * outward + small_m * sin_tube * Vector3::UnitZ(), across,
          along.normalized().cross(across)};
}

/// 2 · rings · sides outward triangles over `vertices`, `sides` of them for each ring in turn.
/// Preconditions: sides ≥ 3, at least three rings, no ring left over.
TriangleMesh closed_tube(std::vector<Vector3> vertices, int sides) {
  const auto count = static_cast<std::uint32_t>(vertices.size());
  const auto corners = static_cast<std::uint32_t>(sides);
  assert(sides >= 3 && count % corners == 0 && count >= 3 * corners);
  TriangleMesh mesh{std::move(vertices), {}};
  for (std::uint32_t ring = 0; ring < count; ring += corners) {
    const std::uint32_t ahead = (ring + corners) % count;
    for (std::uint32_t corner = 0; corner < corners; ++corner) {
      const std::uint32_t next = (corner + 1) % corners;
      mesh.triangles.push_back({ring + corner, ring + next, ahead + next});
      mesh.triangles.push_back({ring + corner, ahead + next, ahead + corner});
    }
  }
  return mesh;
}

}  // namespace

TriangleMesh torus_mesh(double radius_m, double tube_m, int segments, int sides) {
  assert(0.0 < tube_m && tube_m < radius_m && segments >= 3 && sides >= 3);
  std::vector<Vector3> vertices;
  for (int segment = 0; segment < segments; ++segment) {
    const auto [sin_ring, cos_ring] = sine_cosine_deg(360.0 * segment / segments);
    for (int side = 0; side < sides; ++side) {
      const auto [sin_tube, cos_tube] = sine_cosine_deg(360.0 * side / sides);
      // From outside upward is clockwise as seen from ahead, hence the minus.
      const double from_axis_m = radius_m + tube_m * cos_tube;
      vertices.emplace_back(from_axis_m * cos_ring, from_axis_m * sin_ring, -tube_m * sin_tube);
    }
  }
  return closed_tube(std::move(vertices), sides);
}

TriangleMesh knot_mesh(double radius_m, double tube_m, int segments, int sides) {
  assert(0.0 < tube_m && tube_m <= kThickestKnot * radius_m && segments >= 32 && sides >= 3);
  std::vector<Vector3> vertices;
  for (int segment = 0; segment < segments; ++segment) {
    const double turn = static_cast<double>(segment) / segments;
    const auto [place, across, beside] = station_at(radius_m, turn);
    for (int side = 0; side < sides; ++side) {
      const double angle_deg = 360.0 * side / sides + 360.0 * kUntwistingTurns * turn;
      const auto [sine, cosine] = sine_cosine_deg(angle_deg);
      vertices.emplace_back(place + tube_m * (cosine * across + sine * beside));
    }
  }
  return closed_tube(std::move(vertices), sides);
}

}  // namespace impetus::inline shapes
