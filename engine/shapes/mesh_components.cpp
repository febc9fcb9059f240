// SPDX-License-Identifier: MIT
#include "engine/shapes/mesh_components.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "engine/numerics/disjoint_sets.hpp"
#include "engine/shapes/mass_properties.hpp"
#include "engine/shapes/surface_distance.hpp"

namespace impetus::inline shapes {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// The corners (3 · triangle + place) at the lesser and at the greater vertex of an edge.
using EdgeCorners = std::pair<std::uint32_t, std::uint32_t>;

/// Corners of the same vertex in triangles that share an edge there.
DisjointSets fans_of(const TriangleMesh& mesh, DisjointSets& triangles) {
  DisjointSets fans(3 * mesh.triangles.size());
  std::map<std::pair<std::uint32_t, std::uint32_t>, EdgeCorners> first;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      std::uint32_t one = 3 * t + i;
      std::uint32_t other = 3 * t + (i + 1) % 3;
      std::pair edge(mesh.triangles[t][i], mesh.triangles[t][(i + 1) % 3]);
      if (edge.second < edge.first) {
        std::swap(edge.first, edge.second);
        std::swap(one, other);
      }
      const auto [entry, is_new] = first.try_emplace(edge, one, other);
      if (!is_new) {
        triangles.join(t, entry->second.first / 3);
        fans.join(one, entry->second.first);
        fans.join(other, entry->second.second);
      }
    }
  }
  return fans;
}

std::int64_t count_pinched(const TriangleMesh& mesh, DisjointSets fans) {
  std::vector<std::size_t> fan_of(mesh.vertices.size(), kNone);
  std::vector<bool> pinched(mesh.vertices.size(), false);
  std::int64_t count = 0;
  for (std::uint32_t corner = 0; corner < 3 * mesh.triangles.size(); ++corner) {
    const std::uint32_t vertex = mesh.triangles[corner / 3][corner % 3];
    const std::size_t fan = fans.name_of(corner);
    if (fan_of[vertex] == kNone) {
      fan_of[vertex] = fan;
    } else if (fan_of[vertex] != fan && !pinched[vertex]) {
      pinched[vertex] = true;
      ++count;
    }
  }
  return count;
}

constexpr double kFlattest = 0x1p-22;
constexpr std::size_t kVerticesTried = 16;

/// A component looking outward, whichever way it was.
struct Shell {
  TriangleMesh mesh;
  Bounds bounds;
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
  shell.bounds = bounds_of(mesh.vertices);
  shell.volume_m3 = solid_of(mesh, /*density_kg_m3=*/1.0).volume_m3;
  shell.flat = std::abs(shell.volume_m3) <= kFlattest * area_of(mesh) * shell.bounds.sides().norm();
  if (shell.volume_m3 < 0.0) {
    for (auto& triangle : mesh.triangles) {
      std::swap(triangle[1], triangle[2]);
    }
  }
  shell.mesh = std::move(mesh);
  return shell;
}

bool is_inside(const Shell& inner, const Shell& outer) {
  if (outer.flat || (inner.bounds.least.array() < outer.bounds.least.array()).any() ||
      (inner.bounds.most.array() > outer.bounds.most.array()).any()) {
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

MeshComponents find_components(const TriangleMesh& mesh) {
  MeshComponents result;
  DisjointSets triangles(mesh.triangles.size());
  result.pinched_vertices = count_pinched(mesh, fans_of(mesh, triangles));
  std::vector<std::uint32_t> number(mesh.triangles.size(), kNone);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    std::uint32_t& of_root = number[triangles.name_of(t)];
    if (of_root == kNone) {
      of_root = result.count++;
    }
    result.of_triangle.push_back(of_root);
  }
  return result;
}

std::vector<TriangleMesh> split(const TriangleMesh& mesh, const MeshComponents& components) {
  std::vector<TriangleMesh> parts(components.count);
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> index_of;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    TriangleMesh& part = parts[components.of_triangle[t]];
    std::array<std::uint32_t, 3> triangle = mesh.triangles[t];
    for (std::uint32_t& vertex : triangle) {
      const auto next = static_cast<std::uint32_t>(part.vertices.size());
      const auto [entry, is_new] = index_of.try_emplace({components.of_triangle[t], vertex}, next);
      if (is_new) {
        part.vertices.push_back(mesh.vertices[vertex]);
      }
      vertex = entry->second;
    }
    part.triangles.push_back(triangle);
  }
  return parts;
}

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
