// What every builder of trees asks of a mesh.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "engine/shapes/triangle_mesh.hpp"
#include "engine/trees/tree_settings.hpp"

namespace impetus::inline trees {

/// Throws std::invalid_argument in the name of `builder` unless `mesh` is closed, faces outward and
/// encloses more than rounding may have left of nothing: 1e-12 of its bounding cube.
void require_solid(const TriangleMesh& mesh, const std::string& builder);

/// Throws std::invalid_argument where problem_of(settings) is not empty or `mesh` is no solid.
void require_buildable(const TriangleMesh& mesh, const TreeSettings& settings);

/// The box parallel to the axes that holds the triangles (metres): its least and greatest corner.
struct MeshBounds {
  Vector3 least;
  Vector3 most;
};

/// Precondition: one triangle or more. Vertices of no triangle do not count.
MeshBounds bounds_of(const TriangleMesh& mesh);

}  // namespace impetus::inline trees
