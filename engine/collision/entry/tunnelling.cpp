// SPDX-License-Identifier: MIT
#include "engine/collision/entry/tunnelling.hpp"

#include <algorithm>

namespace impetus::inline collision {

int capped_level(const VolumeTree& a, const VolumeTree& b, double way_m, int greatest_level) {
  const int finest = std::max(a.level_count(), b.level_count()) - 1;
  for (int level = 1; level <= std::min(finest, greatest_level); ++level) {
    if (way_m > std::min(a.least_half_thickness_m(level), b.least_half_thickness_m(level))) {
      return level - 1;
    }
  }
  return greatest_level;
}

}  // namespace impetus::inline collision
