// Meshes of a scene from files, held by content.
//
//   "shape": {"kind": "mesh", "file": "dragon.obj", ...}
//        │ read once, when the scene is
//        └─> "meshes": {"dragon.obj": {"hash": ..., "base64": ...}}
//
// The scene that a study records therefore holds all that a replay needs, and the hash of a
// protocol covers its meshes: a file that changes makes another protocol.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "engine/shapes/triangle_mesh.hpp"
#include "experiments/scenes/scene.hpp"

namespace impetus::inline scenes {

/// A shape of the scene that names a mesh file.
struct MeshFile {
  std::string pointer;  ///< to "file"
  std::string file;
};

/// Those that the scene names, in its order, and those that the figures it holds name.
std::vector<MeshFile> named_mesh_files(const Scene& scene);

/// The mesh that `meshes` holds for a file, in the file's own units. Throws std::runtime_error
/// (expected ..., got ...) when the content is not what it says.
TriangleMesh mesh_content(const Meshes& meshes, const std::string& file);

}  // namespace impetus::inline scenes
