// Mesh files through assimp, in this very process: a file that is made to may end it.
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "engine/shapes/triangle_mesh.hpp"

namespace impetus::inline models {

/// What load_mesh() does beyond keeping itself safe. Precondition: `file` is a file.
TriangleMesh parse_mesh(const std::filesystem::path& file);

}  // namespace impetus::inline models
