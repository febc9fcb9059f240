// SPDX-License-Identifier: MIT
#include "engine/collision/broad_phase.hpp"

namespace impetus::inline collision {

bool could_meet(const MovedBound& a, const MovedBound& b) {
  Sphere swept = a.bound;
  swept.radius_m += a.travelled_m + b.travelled_m;
  return overlap(swept, b.bound);
}

void find_among_all(const std::vector<MovedBound>& bodies, std::vector<PairBounds>& pairs) {
  pairs.clear();
  for (std::size_t b = 1; b < bodies.size(); ++b) {
    for (std::size_t a = 0; a < b; ++a) {
      if (!bodies[a].movable && !bodies[b].movable) {
        continue;
      }
      if (could_meet(bodies[a], bodies[b])) {
        const BodyPair pair{static_cast<std::int32_t>(a), static_cast<std::int32_t>(b)};
        pairs.push_back({pair, bodies[a].bound, bodies[b].bound});
      }
    }
  }
}

std::vector<PairBounds> candidate_pairs(const std::vector<MovedBound>& bodies) {
  std::vector<PairBounds> pairs;
  find_among_all(bodies, pairs);
  return pairs;
}

}  // namespace impetus::inline collision
