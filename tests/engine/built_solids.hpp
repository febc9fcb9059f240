// Solids that trees are built round, and what a built tree must be.
// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "engine/shapes/mass_properties.hpp"
#include "engine/shapes/solids/ball_meshes.hpp"
#include "engine/shapes/solids/block_meshes.hpp"
#include "engine/shapes/solids/creature_mesh.hpp"
#include "engine/shapes/solids/ring_meshes.hpp"
#include "engine/trees/node_description.hpp"

namespace impetus {

struct BuiltSolid {
  const char* name;
  TriangleMesh mesh;
};

inline TriangleMesh moved(TriangleMesh mesh, const Vector3& by) {
  for (Vector3& vertex : mesh.vertices) {
    vertex += by;
  }
  return mesh;
}

inline TriangleMesh scaled(TriangleMesh mesh, double by) {
  for (Vector3& vertex : mesh.vertices) {
    vertex *= by;
  }
  return mesh;
}

/// Both surfaces in one mesh.
inline TriangleMesh together(TriangleMesh a, const TriangleMesh& b) {
  const auto offset = static_cast<std::uint32_t>(a.vertices.size());
  a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (const auto& [i, j, k] : b.triangles) {
    a.triangles.push_back({i + offset, j + offset, k + offset});
  }
  return a;
}

inline std::vector<BuiltSolid> small_solids() {
  const TriangleMesh block = about_centre_of_mass(l_block_mesh(2.0, 0.7));
  return {{"box", box_mesh({1.0, 0.6, 0.35})},
          {"dyadic box", box_mesh({1.0, 0.5, 0.25})},
          {"L-block", block},
          {"L-block of a micrometre", scaled(block, 1e-6)},
          {"L-block of a thousand kilometres", scaled(block, 1e6)},
          {"icosphere", icosphere_mesh(0.4, 1)},
          {"torus", torus_mesh(1.0, 0.3, 16, 8)},
          {"needle", box_mesh({1.0, 1e-4, 1e-4})},
          {"plate", box_mesh({1.0, 0.8, 0.002})},
          {"two bodies",
           together(icosphere_mesh(0.3, 1), moved(box_mesh({0.2, 0.3, 0.4}), {1.0, 0.5, 0.2}))}};
}

inline double size_of(const TriangleMesh& mesh) {
  double size_m = 0.0;
  for (const Vector3& vertex : mesh.vertices) {
    size_m = std::max(size_m, (vertex - mesh.vertices.front()).cwiseAbs().maxCoeff());
  }
  return size_m;
}

inline double area_of_facet(const Facet& facet) { return 0.5 * doubled_area_vector(facet).norm(); }

/// How far outside the convex `outer` a point of its plane lies (metres).
inline double distance_outside(const Facet& outer, const Vector3& point) {
  const Vector3 normal = outer.normal.normalized();
  double outside_m = std::fabs(normal.dot(point - outer.corners[0]));
  for (std::size_t i = 0; i < outer.corners.size(); ++i) {
    const Vector3& from = outer.corners[i];
    const Vector3 along = outer.corners[(i + 1) % outer.corners.size()] - from;
    if (along.norm() > 0.0) {
      const Vector3 outward = along.cross(normal).normalized();
      outside_m = std::max(outside_m, outward.dot(point - from));
    }
  }
  return outside_m;
}

/// By triangle: a part is cut by planes alone, so it holds one convex piece of each at most.
inline std::map<std::uint32_t, const Facet*> by_triangle(const SurfacePart& part) {
  std::map<std::uint32_t, const Facet*> pieces;
  for (const Facet& facet : part) {
    EXPECT_TRUE(pieces.emplace(facet.triangle, &facet).second) << "two pieces of one triangle";
  }
  return pieces;
}

/// The root's part is the whole mesh; children's parts lie in their parent's and tile it; every
/// volume holds its part's corners. So every level holds the whole surface.
inline void expect_covers(const BuiltTree& built, const TriangleMesh& mesh,
                          const std::string& name) {
  const VolumeTree& tree = built.tree;
  const double size_m = size_of(mesh);
  ASSERT_EQ(built.parts.size(), static_cast<std::size_t>(tree.node_count())) << name;
  ASSERT_EQ(built.parts[0].size(), mesh.triangles.size()) << name;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Facet& facet = built.parts[0][i];
    ASSERT_EQ(facet.corners.size(), 3U);
    for (std::size_t corner = 0; corner < 3; ++corner) {
      ASSERT_EQ(facet.corners[corner], mesh.vertices[mesh.triangles[i][corner]]) << name;
    }
  }
  for (std::int32_t node = 0; node < tree.node_count(); ++node) {
    const SurfacePart& part = built.parts[static_cast<std::size_t>(node)];
    const Volume volume = tree.volume(node);
    for (const Vector3& corner : corners_of(part)) {
      ASSERT_TRUE(holds(volume, corner)) << name << ", node " << node;
    }
    const auto& [first, count] = tree.links(node);
    if (count == 0) {
      continue;
    }
    const std::map<std::uint32_t, const Facet*> outer = by_triangle(part);
    std::map<std::uint32_t, double> area_left;
    for (const auto& [triangle, facet] : outer) {
      area_left[triangle] = area_of_facet(*facet);
    }
    for (std::int32_t child = first; child < first + count; ++child) {
      for (const auto& [triangle, facet] :
           by_triangle(built.parts[static_cast<std::size_t>(child)])) {
        ASSERT_TRUE(outer.count(triangle) == 1) << name << ", node " << child;
        area_left[triangle] -= area_of_facet(*facet);
        for (const Vector3& corner : facet->corners) {
          ASSERT_LT(distance_outside(*outer.at(triangle), corner), 1e-11 * size_m)
              << name << ", node " << child;
        }
      }
    }
    for (const auto& [triangle, area_m2] : area_left) {
      ASSERT_LT(std::fabs(area_m2), 1e-11 * size_m * size_m) << name << ", node " << node;
    }
  }
}

}  // namespace impetus
