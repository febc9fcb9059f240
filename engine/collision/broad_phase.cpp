// SPDX-License-Identifier: MIT
#include "engine/collision/broad_phase.hpp"

namespace impetus {

std::vector<PairBounds> candidate_pairs(const std::vector<MovedBound>& bodies) {
  std::vector<PairBounds> pairs;
  for (std::size_t b = 1; b < bodies.size(); ++b) {
    for (std::size_t a = 0; a < b; ++a) {
      if (!bodies[a].movable && !bodies[b].movable) {
        continue;
      }
      Sphere swept = bodies[a].bound;
      swept.radius_m += bodies[a].travelled_m + bodies[b].travelled_m;
      if (overlap(swept, bodies[b].bound)) {
        const BodyPair pair{static_cast<std::int32_t>(a), static_cast<std::int32_t>(b)};
        pairs.push_back({pair, bodies[a].bound, bodies[b].bound});
      }
    }
  }
  return pairs;
}

}  // namespace impetus
