// What is done about bodies that move further in a step than they are thick.
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/scheduling/priority.hpp"
#include "engine/trees/volume_tree.hpp"

namespace impetus::inline collision {

/// (Dingliana 2002, sec. 5.3.2)
enum class Tunnelling {
  kIgnored,      ///< bodies are tested where the step ends
  kCapped,       ///< fast pairs stay at levels whose nodes are thicker than the way: Alg. 5.3.1
  kStopAtEntry,  ///< fast pairs are tested along their way, and stopped where they first touch
};

/// A pair that would have passed into or through each other unseen, and was stopped.
struct StoppedAtEntry {
  BodyPair bodies;
  double fraction{0.0};  ///< of the step that both were moved
};

/// The deepest level, no deeper than `greatest_level`, to which a pair is refined whose points move
/// by up to `way_m` against each other in the step: at every level from 1 to it, no node is thinner
/// than twice that way. The coarsest is never refused. (Dingliana 2002, alg. 5.3.1, corrected: by
/// the relative way, and once for the pair)
int capped_level(const VolumeTree& a, const VolumeTree& b, double way_m, int greatest_level);

}  // namespace impetus::inline collision
