// Triangles that add nothing to a surface: without area, or there already.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

#include "engine/shapes/triangle_mesh.hpp"

namespace impetus::inline shapes {

/// Whether the triangle has a repeated vertex or no area.
bool is_degenerate(const TriangleMesh& mesh, const std::array<std::uint32_t, 3>& triangle);

/// How many triangles have the vertices of an earlier one, either way round.
std::int64_t count_duplicates(const TriangleMesh& mesh);

}  // namespace impetus::inline shapes
