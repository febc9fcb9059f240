// A mesh as bytes, exactly, and the name of its content.
//
//   vertices (x y z, double) ... triangles (a b c, unsigned 32 bits) ...    all little-endian
//
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "engine/shapes/triangle_mesh.hpp"
#include "experiments/models/little_endian.hpp"

namespace impetus::inline models {

struct MeshCounts {
  std::uint64_t vertices{0};
  std::uint64_t triangles{0};
};

void append_mesh(std::string& bytes, const TriangleMesh& mesh);

/// Throws std::out_of_range when bytes are missing, std::runtime_error (expected ..., got ...) when
/// a coordinate is not finite or a triangle names a vertex that is not there.
TriangleMesh take_mesh(ByteReader& bytes, const MeshCounts& counts);

/// 32 hexadecimal digits (XXH3, 128 bits): equal content, equal name.
std::string content_hash(std::string_view bytes);

/// Of the counts and the bytes of append_mesh().
std::string content_hash(const TriangleMesh& mesh);

}  // namespace impetus::inline models
