// What a mesh file says of itself that cannot be so, or could not be meant: asked before its reader
// believes it.
//
//   PLY    counts of elements, properties and lists     OFF    counts, and lines
//   glTF   files, counts, and which node holds which    GLB    the same, and its length
//
// assimp takes memory and time for whatever a file claims to hold. OBJ and STL claim nothing.
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace impetus::inline models {

/// Throws std::runtime_error, in one sentence that names the file. Precondition: it can be read.
void refuse_false_claims(const std::filesystem::path& file);

}  // namespace impetus::inline models
