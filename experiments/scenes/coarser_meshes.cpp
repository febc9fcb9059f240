// SPDX-License-Identifier: MIT
#include "experiments/scenes/coarser_meshes.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/shapes/mesh_reduction.hpp"
#include "engine/shapes/surface_distance.hpp"

namespace impetus {
namespace {

constexpr std::size_t kFewestTriangles = 40;

/// The root of the mean squared distance of `from` to the surface of `to`, over the area of `from`:
/// at the middles of its triangles' sides, by which a quadratic is integrated exactly.
double mean_distance_m(const TriangleMesh& from, const SurfaceDistance& to) {
  double sum_m4 = 0.0;
  double area_m2 = 0.0;
  std::uint32_t near = 0;
  for (const auto& triangle : from.triangles) {
    const Vector3& a = from.vertices[triangle[0]];
    const Vector3& b = from.vertices[triangle[1]];
    const Vector3& c = from.vertices[triangle[2]];
    double squares_m2 = 0.0;
    for (const Vector3& sum : {Vector3(a + b), Vector3(b + c), Vector3(c + a)}) {
      const NearestOnSurface found = to.nearest(0.5 * sum, near);
      near = found.triangle;
      squares_m2 += found.distance_m * found.distance_m;
    }
    const double triangle_m2 = 0.5 * (b - a).cross(c - a).norm();
    sum_m4 += triangle_m2 * squares_m2 / 3.0;
    area_m2 += triangle_m2;
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

}  // namespace impetus
