// A mesh with the normals it is shaded by: hard where two faces meet sharply, averaged elsewhere.
//
//   corners of triangles --join across soft edges--> groups, one vertex and one normal each
//
// A vertex of a box falls into three groups, one per face; a vertex of a fine sphere is one.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/shapes/triangle_mesh.hpp"

namespace impetus::inline drawing {

/// A corner of a mesh as it goes to the graphics card.
struct ShadedVertex {
  std::array<float, 3> position;  ///< metres, in the mesh's frame
  std::array<float, 3> normal;    ///< unit; zero where every triangle is degenerate
};

/// A mesh as it goes to the graphics card.
struct ShadedMesh {
  std::vector<ShadedVertex> vertices;
  std::vector<std::uint32_t> indices;  ///< three per triangle, in the mesh's order
};

/// Every vertex index of the mesh must be within its vertices. Only triangles that name the same
/// vertices share an edge, which is hard when the normals of its two triangles are farther apart
/// than `hard_edge_deg`. A face's part in an averaged normal is the angle of its corner.
ShadedMesh shaded_mesh(const TriangleMesh& mesh, double hard_edge_deg);

}  // namespace impetus::inline drawing
