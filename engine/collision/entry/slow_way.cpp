// SPDX-License-Identifier: MIT
#include "engine/collision/entry/slow_way.hpp"

#include <algorithm>

namespace impetus::inline collision {
namespace {

/// Deep in a voxel the nearest face may be one that it shares with the next: then nothing pushes
/// out of the body. So much of its half-thickness is safe.
constexpr double kSafeShareOfVoxel = 0.05;

/// How deep a finest node may be met without its being left on the wrong side (metres).
double safe_depth_m(const VolumeTree& tree, int level) {
  const double half_m = tree.least_half_thickness_m(level);
  return tree.volumes().are_voxels() ? kSafeShareOfVoxel * half_m : half_m;
}

}  // namespace

double slow_way_m(const VolumeTree& a, const VolumeTree& b, int level) {
  return safe_depth_m(a, level) + safe_depth_m(b, level);
}

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
