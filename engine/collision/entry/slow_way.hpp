// How far a pair of bodies may move in a step before their ways are looked at: by how thick the
// finest nodes are that it is refined to. And to which nodes it is refined when it moves further.
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/trees/volume_tree.hpp"

namespace impetus::inline collision {

/// What a pair may move without being fast (metres): the least half-thickness of a's nodes and
/// that of b's, of voxels a twentieth. Bodies that move less against each other cannot get past
/// their middles between one step and the next.
double slow_way_m(const VolumeTree& a, const VolumeTree& b, int level);

/// The deepest level, no deeper than `greatest_level`, to which a pair is refined whose points move
/// by up to `way_m` against each other in the step: at every level from 1 to it, no node is thinner
/// than twice that way. The coarsest is never refused. (Dingliana 2002, alg. 5.3.1, corrected: by
/// the relative way, and once for the pair)
int capped_level(const VolumeTree& a, const VolumeTree& b, double way_m, int greatest_level);

}  // namespace impetus::inline collision
