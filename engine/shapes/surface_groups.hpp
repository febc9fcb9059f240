// The nearly plane pieces of a surface: contacts on one piece may be averaged.
//
// Fine meshes are reduced first. The largest triangle that has no group starts one, which takes the
// neighbour that is most nearly parallel until none lies within kGroupCosine of the group's normal;
// then each triangle of the fine mesh joins the group of the reduced triangle nearest to it that
// faces the same way. (Dingliana 2002, sec. 4.2.3 and fig. 4.14)
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/shapes/triangle_mesh.hpp"

namespace impetus::inline shapes {

/// A triangle joins a group when the cosine between its normal and the area-weighted mean of the
/// group's is not below this: 25.8°.
inline constexpr double kGroupCosine = 0.9;
/// Meshes of more triangles than the first are reduced to the second.
inline constexpr std::size_t kFineMesh = 400;
inline constexpr std::size_t kReducedMesh = 200;

/// For each triangle its group, numbered from 0. Groups of a mesh that is not fine are connected
/// through edges. Precondition: find_defects(mesh).none().
std::vector<std::int32_t> surface_groups(const TriangleMesh& mesh);

}  // namespace impetus::inline shapes
