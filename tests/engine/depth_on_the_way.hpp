// How deep two bodies overlap on their ways.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "engine/collision/entry/time_of_entry.hpp"
#include "engine/collision/pair_refinement.hpp"

namespace impetus {

/// How deep the finest nodes that the refinement reaches overlap at the moment; −1 when none do.
inline double depth_at(const PairOnTheWay& pair, double time) {
  pair.a.move_to(pose_at(pair.path_a, time));
  pair.b.move_to(pose_at(pair.path_b, time));
  PairRefinement refinement(pair.a, pair.b, pair.greatest_level);
  while (!refinement.resolved()) {
    refinement.refine_one_block();
  }
  double depth_m = -1.0;
  for (const NodePair& nodes : refinement.overlapping()) {
    const TouchPoint touch =
        touch_of_nodes(pair.a, nodes.a, pair.b, nodes.b, Vector3(Vector3::UnitX()));
    depth_m = std::max(depth_m, touch.depth_m);
  }
  return depth_m;
}

}  // namespace impetus
