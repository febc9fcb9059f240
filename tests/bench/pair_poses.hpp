// Two bodies at many random poses, and whether their surfaces cross there.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "tests/bench/crowd_starts.hpp"
#include "tests/engine/mesh_oracles.hpp"

namespace impetus {

/// The share of the poses at which surfaces should cross: 771 of 2,000 in the anchors.
inline constexpr double kCrossingShare = 771.0 / 2000.0;

/// The second body; the first has the identity.
struct PairPose {
  Pose b;
  bool surfaces_cross{false};  ///< exactly, by the triangles
};

/// Turned at random, and centres at random in a ball about the first's, as large as makes surfaces
/// cross at about the share above.
std::vector<PairPose> random_pair_poses(const TriangleMesh& mesh, int count);

/// intersects() of the mesh with itself at the pose; triangles outside the box that both meshes
/// share are left out first.
bool crosses_itself_at(const TriangleMesh& mesh, const Pose& pose);

}  // namespace impetus
