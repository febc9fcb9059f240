// Triangle meshes to files: OBJ, PLY (text) and STL (text).
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "engine/shapes/triangle_mesh.hpp"

namespace impetus::inline models {

/// Whether the file's extension names a format that can be written: .obj, .ply or .stl.
bool can_write_mesh(const std::filesystem::path& file);

/// Writes a new file with nine significant digits, which keep single precision exactly. Throws
/// std::runtime_error, in one sentence that names the file, when its extension is none of the
/// three, when it exists (nothing is ever overwritten) or when it cannot be written.
void write_mesh(const TriangleMesh& mesh, const std::filesystem::path& file);

}  // namespace impetus::inline models
