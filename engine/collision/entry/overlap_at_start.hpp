// How deep two bodies overlap where their ways begin.
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/collision/entry/counted_pairs.hpp"

namespace impetus::inline collision {

/// Of the finest nodes that are looked at.
struct OverlapAtStart {
  bool any{false};
  double depth_m{0.0};
};

/// Where `pairs` are now; deeper than `enough_m` is deep enough, and nothing more is looked at.
OverlapAtStart overlap_at_start(CountedPairs& pairs, double enough_m);

}  // namespace impetus::inline collision
