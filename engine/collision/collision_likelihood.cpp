// How likely it is that the surfaces of a pair meet where its nodes do. (Dingliana 2002, eq. 4.6)
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "engine/collision/pair_refinement.hpp"

namespace impetus::inline collision {
namespace {

/// κ of the spheres about the nodes, (R_a + R_b − d) / (2 min(R_a, R_b)) in [0, 1], for it need
/// only order the pairs.
double nesting(const Sphere& a, const Sphere& b) {
  const double smaller_m = std::min(a.radius_m, b.radius_m);
  const double reach_m = a.radius_m + b.radius_m - (a.centre - b.centre).norm();
  return smaller_m > 0.0 ? std::clamp(reach_m / (2.0 * smaller_m), 0.0, 1.0) : 1.0;
}

}  // namespace

double PairRefinement::likeliest_collision() const {
  double likeliest = 0.0;
  for (const NodePair& pair : committed_) {
    const Sphere of_a = bounding_sphere(a_->world_volume(pair.a));
    double kappa = 0.0;
    double occupancy = a_->tree().surface(pair.a).occupancy;
    if (b_ != nullptr) {
      kappa = nesting(of_a, bounding_sphere(b_->world_volume(pair.b)));
      occupancy *= b_->tree().surface(pair.b).occupancy;
    } else {
      for (int wall = 0; wall < kWallCount; ++wall) {
        const double depth_m = touch_of_wall(*a_, pair.a, *walls_, wall).depth_m;
        kappa = std::max(kappa, of_a.radius_m > 0.0
                                    ? std::clamp(depth_m / (2.0 * of_a.radius_m), 0.0, 1.0)
                                    : 1.0);
      }
    }
    likeliest = std::max(likeliest, kappa * occupancy);
  }
  return likeliest;
}

}  // namespace impetus::inline collision
