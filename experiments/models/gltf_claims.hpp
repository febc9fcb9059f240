// What a glTF file claims to hold, and which files it names.
//
//   scene ─> nodes, a tree ─> meshes ─> primitives ─> accessors ─> buffers, each a file or text
//
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace impetus::inline models {

/// What is wrong, in words ("/buffers/0/uri: expected ..., got ..."); "" when nothing: a buffer
/// lies outside `folder` or cannot be read, a node has two parents, an accessor claims more values
/// than there are bytes, or the nodes place the same mesh without end. Textures are not read.
std::string gltf_problem(std::string_view bytes, const std::filesystem::path& folder);

}  // namespace impetus::inline models
