// SPDX-License-Identifier: MIT
#include "experiments/scenes/coarser_meshes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "engine/shapes/mesh_reduction.hpp"
#include "engine/shapes/surface_distance.hpp"

namespace impetus::inline scenes {
namespace {

constexpr std::size_t kFewestTriangles = 40;

/// A point of a triangle by its shares of the corners, and its weight in a mean over the area.
struct WeightedPoint {
  Vector3 shares;
  double weight;
};

/// Corners, middles of sides, middle: right for cubic polynomials (Strang and Fix 1973).
const std::array<WeightedPoint, 7>& points_of_a_triangle() {
  constexpr double kHalf = 0.5;
  constexpr double kThird = 1.0 / 3.0;
  static const std::array<WeightedPoint, 7> points{{{{1.0, 0.0, 0.0}, 3.0 / 60.0},
                                                    {{0.0, 1.0, 0.0}, 3.0 / 60.0},
                                                    {{0.0, 0.0, 1.0}, 3.0 / 60.0},
                                                    {{kHalf, kHalf, 0.0}, 8.0 / 60.0},
                                                    {{0.0, kHalf, kHalf}, 8.0 / 60.0},
                                                    {{kHalf, 0.0, kHalf}, 8.0 / 60.0},
                                                    {{kThird, kThird, kThird}, 27.0 / 60.0}}};
  return points;
}

/// The root of the mean squared distance of `from` to the surface of `to`, over the area of `from`.
double mean_distance_m(const TriangleMesh& from, const SurfaceDistance& to) {
  double sum_m4 = 0.0;
  double area_m2 = 0.0;
  std::uint32_t near = 0;
  for (const auto& triangle : from.triangles) {
    Matrix3 corners;
    corners << from.vertices[triangle[0]], from.vertices[triangle[1]], from.vertices[triangle[2]];
    const double triangle_m2 =
        0.5 * (corners.col(1) - corners.col(0)).cross(corners.col(2) - corners.col(0)).norm();
    area_m2 += triangle_m2;
    for (const WeightedPoint& point : points_of_a_triangle()) {
      const NearestOnSurface found = to.nearest(corners * point.shares, near);
      near = found.triangle;
      sum_m4 += triangle_m2 * point.weight * found.distance_m * found.distance_m;
    }
  }
  return std::sqrt(sum_m4 / area_m2);
}

}  // namespace

DrawnLevels coarser_meshes(const TriangleMesh& mesh, const Progress& progress) {
  DrawnLevels levels;
  if (mesh.triangles.size() < 2 * kFewestTriangles) {
    return levels;
  }
  const SurfaceDistance surface(mesh);
  double deviation_m = 0.0;
  std::size_t finer = mesh.triangles.size();
  for (std::size_t wanted = finer / 2; wanted >= kFewestTriangles; wanted /= 2) {
    TriangleMesh reduced = reduced_mesh(mesh, wanted);
    if (reduced.triangles.size() >= finer) {
      break;
    }
    finer = reduced.triangles.size();
    deviation_m = std::max({deviation_m, mean_distance_m(mesh, SurfaceDistance(reduced)),
                            mean_distance_m(reduced, surface)});
    levels.push_back({std::make_shared<const TriangleMesh>(std::move(reduced)), deviation_m});
    if (progress) {
      progress(1.0 - static_cast<double>(wanted) / static_cast<double>(mesh.triangles.size()));
    }
  }
  return levels;
}

}  // namespace impetus::inline scenes
