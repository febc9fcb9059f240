// SPDX-License-Identifier: MIT
#include "engine/shapes/mending/component_orientation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/shapes/mass_properties.hpp"
#include "engine/shapes/point_in_solid.hpp"

namespace impetus::inline shapes {
namespace {

constexpr double kFlattest = 0x1p-22;
constexpr std::size_t kVerticesTried = 16;

/// A component looking outward, whichever way it was.
struct Shell {
  TriangleMesh mesh;
  Vector3 least;
  Vector3 most;
  double volume_m3{0.0};  // as it was
  bool flat{false};
};

double area_of(const TriangleMesh& mesh) {
  double twice = 0.0;
  for (const auto& [a, b, c] : mesh.triangles) {
    twice +=
        (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]).norm();
  }
  return twice / 2.0;
}

Shell shell_of(TriangleMesh mesh) {
  Shell shell;
  shell.least = mesh.vertices.front();
  shell.most = mesh.vertices.front();
  for (const Vector3& vertex : mesh.vertices) {
    shell.least = shell.least.cwiseMin(vertex);
    shell.most = shell.most.cwiseMax(vertex);
  }
  shell.volume_m3 = solid_of(mesh, /*density_kg_m3=*/1.0).volume_m3;
  shell.flat =
      std::abs(shell.volume_m3) <= kFlattest * area_of(mesh) * (shell.most - shell.least).norm();
  if (shell.volume_m3 < 0.0) {
    for (auto& triangle : mesh.triangles) {
      std::swap(triangle[1], triangle[2]);
    }
  }
  shell.mesh = std::move(mesh);
  return shell;
}

bool is_inside(const Shell& inner, const Shell& outer) {
  if (outer.flat || (inner.least.array() < outer.least.array()).any() ||
      (inner.most.array() > outer.most.array()).any()) {
    return false;
  }
  const std::size_t vertices = inner.mesh.vertices.size();
  const std::size_t tried = std::min(vertices, kVerticesTried);
  for (std::size_t i = 0; i < tried; ++i) {
    if (!contains(outer.mesh, inner.mesh.vertices[i * vertices / tried])) {
      return false;
    }
  }
  return true;
}

}  // namespace

ComponentOrientation orientation_of(const TriangleMesh& mesh, const MeshComponents& components) {
  std::vector<Shell> shells;
  for (TriangleMesh& part : split(mesh, components)) {
    shells.push_back(shell_of(std::move(part)));
  }
  ComponentOrientation result;
  for (std::size_t i = 0; i < shells.size(); ++i) {
    bool is_cavity = false;
    for (std::size_t j = 0; j < shells.size(); ++j) {
      is_cavity = is_cavity != (j != i && is_inside(shells[i], shells[j]));
    }
    result.flat.push_back(shells[i].flat);
    result.turned.push_back(!shells[i].flat && (shells[i].volume_m3 < 0.0) != is_cavity);
  }
  return result;
}

}  // namespace impetus::inline shapes
