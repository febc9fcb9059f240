// SPDX-License-Identifier: MIT
#include "engine/trees/solid_requirement.hpp"

#include <stdexcept>

#include "engine/shapes/mass_properties.hpp"

namespace impetus::inline trees {
namespace {

constexpr double kLeastShare = 1e-12;

}  // namespace

void require_buildable(const TriangleMesh& mesh, const TreeSettings& settings) {
  const std::string problem = problem_of(settings);
  if (!problem.empty()) {
    throw std::invalid_argument(problem);
  }
  require_solid(mesh, "tree");
}

MeshBounds bounds_of(const TriangleMesh& mesh) {
  Vector3 least = mesh.vertices[mesh.triangles.front()[0]];
  Vector3 most = least;
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t vertex : triangle) {
      least = least.cwiseMin(mesh.vertices[vertex]);
      most = most.cwiseMax(mesh.vertices[vertex]);
    }
  }
  return {least, most};
}

void require_solid(const TriangleMesh& mesh, const std::string& builder) {
  if (mesh.triangles.empty() || !find_defects(mesh).none()) {
    throw std::invalid_argument(builder +
                                ": expected a closed mesh with its triangles facing outward");
  }
  const double volume_m3 = solid_of(mesh, /*density_kg_m3=*/1.0).volume_m3;
  const MeshBounds bounds = bounds_of(mesh);
  const double side_m = (bounds.most - bounds.least).maxCoeff();
  if (!(volume_m3 > 0.0)) {
    throw std::invalid_argument(builder +
                                ": expected a closed mesh with its triangles facing outward");
  }
  if (volume_m3 / side_m / side_m / side_m < kLeastShare) {
    throw std::invalid_argument(builder +
                                ": expected a solid, got a mesh that encloses next to nothing");
  }
}

}  // namespace impetus::inline trees
