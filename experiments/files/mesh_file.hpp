// Triangle meshes from files, through assimp: OBJ, PLY, STL, OFF and glTF.
//
//   file --assimp--> meshes in a tree of nodes --place, weld, merge--> one TriangleMesh
//
// Normals, texture coordinates and materials are dropped, and vertices at exactly the same place
// become one: without that every STL, and every OBJ with hard edges, would look open.
//
// assimp's readers crash over some damaged files, so they run in a process of their own.
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "engine/shapes/triangle_mesh.hpp"

namespace impetus::inline files {

/// All surfaces of the file as one mesh, in the file's own units taken as metres. Positions are
/// single precision (assimp's). Throws std::runtime_error, in one sentence that names the file,
/// when it is missing, unreadable, has no triangles, an index out of range or a coordinate that is
/// not finite. Defects of the surface are not errors here: see report_mesh().
TriangleMesh load_mesh(const std::filesystem::path& file);

}  // namespace impetus::inline files
