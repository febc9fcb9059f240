// Two bodies at many random poses, and whether their surfaces cross there.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "tests/bench/crowd_starts.hpp"

namespace impetus {

/// Of the centres, at most: surfaces then cross at about 771 of 2,000 poses, as in the anchors.
inline constexpr double kPairReach_m = 1.5;

/// The second body; the first has the identity.
struct PairPose {
  Pose b;
  bool surfaces_cross{false};  ///< exactly, by the triangles
};

/// Turned at random, and centres at random in a ball of `reach_m` about the first's.
std::vector<PairPose> random_pair_poses(const TriangleMesh& mesh, int count, double reach_m);

/// intersects() of the mesh with itself at the pose; triangles outside the box that both meshes
/// share are left out first.
bool crosses_itself_at(const TriangleMesh& mesh, const Pose& pose);

}  // namespace impetus
