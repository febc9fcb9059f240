// How deep the nodes of a pair overlap, at most: cheap beside their contact, and close to its depth
// where it is little.
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "engine/collision/pair_refinement.hpp"
#include "engine/volumes/core.hpp"

namespace impetus::inline collision {
namespace {

/// By how far two cored volumes would have to move apart along `axis` (unit) to part.
double overlap_along(const CoredVolume& a, const CoredVolume& b, const Vector3& axis) {
  return a.radius_m + b.radius_m + reach_along(a.core, axis) + reach_along(b.core, axis) -
         std::abs((a.core.centre - b.core.centre).dot(axis));
}

double overlap_m(const CoredVolume& a, const CoredVolume& b) {
  const Vector3 offset = a.core.centre - b.core.centre;
  const double distance_m = offset.norm();
  double least_m = overlap_along(
      a, b, distance_m > 0.0 ? Vector3(offset / distance_m) : Vector3(Vector3::UnitX()));
  for (const Core* core : {&a.core, &b.core}) {
    for (int axis = 0; core->dimension > 0 && axis < 3; ++axis) {
      least_m = std::min(least_m, overlap_along(a, b, core->axes.col(axis)));
    }
  }
  return least_m;
}

double overlap_m(const Sphere& a, const Sphere& b) {
  return a.radius_m + b.radius_m - (a.centre - b.centre).norm();
}

}  // namespace

double PairRefinement::deepest_overlap_m() const {
  double deepest_m = 0.0;
  for (const NodePair& pair : committed_) {
    double depth_m = 0.0;
    if (of_spheres_) {
      depth_m = overlap_m(a_->world_sphere(pair.a), b_->world_sphere(pair.b));
    } else if (b_ != nullptr) {
      depth_m = overlap_m(cored(a_->world_volume(pair.a)), cored(b_->world_volume(pair.b)));
    } else {
      for (int wall = 0; wall < kWallCount; ++wall) {
        depth_m = std::max(depth_m, reach_beyond(*walls_, wall, a_->world_volume(pair.a)));
      }
    }
    deepest_m = std::max(deepest_m, depth_m);
  }
  return deepest_m;
}

}  // namespace impetus::inline collision
