// What a mesh file says of itself that cannot be so, or could not be meant: asked before its reader
// believes it.
//
//   PLY    counts of elements, properties and lists     OFF    counts, and lines
//   glTF   files, counts, and which node holds which    STL    its count
//   GLB    the same, and its length
//
// assimp takes memory and time for whatever a file claims to hold. OBJ claims nothing.
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string_view>

namespace impetus::inline files {

/// Throws std::runtime_error, in one sentence that names the file. Precondition: it can be read.
void refuse_false_claims(const std::filesystem::path& file);

/// What a mesh file claims of itself is false: the words are what().
class FalseClaim : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Throws FalseClaim ("/buffers/0/uri: expected ..., got ...") where a buffer lies outside `folder`
/// or cannot be read, a node has two parents, an accessor claims more values than there are bytes,
/// or the nodes place the same mesh without end. Textures are not read.
void check_gltf(std::string_view bytes, const std::filesystem::path& folder);

}  // namespace impetus::inline files
