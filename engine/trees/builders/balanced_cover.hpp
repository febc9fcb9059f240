// Few spheres over a part, chosen so that the next level can follow each of them equally well.
//
// Where the surface under one sphere is more intricate than under the others, its children fit
// worse, and the worst decides the level. Such a sphere is pressed to give some of its surface to
// its neighbours, until that helps no more or makes this level too loose.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "engine/trees/builders/sphere_cover.hpp"
#include "engine/volumes/sphere.hpp"

namespace impetus::inline trees {

struct BalancedCover {
  std::vector<Sphere> spheres;   ///< their power cells are the parts of the children
  double stand_off_m{0.0};       ///< with which one sphere each can cover the cells
  double next_stand_off_m{0.0};  ///< with which as many spheres each can
  double outside_m3{0.0};        ///< volumes of the spheres outside the solid, summed

  /// Which of two covers is better: the product of what should be small. Stand-offs up to `limit_m`
  /// are as good as any; the next level's is a length and so counts more than a volume.
  [[nodiscard]] double cost(double limit_m) const;
};

/// `most` spheres or fewer over `points`; candidate i is the medial ball at point i. Above
/// `limit_m`, the stand-off of these spheres counts against a partition.
BalancedCover balanced_cover(const SurfaceDistance& surface, const OutsidePoints& outside,
                             const std::vector<Vector3>& points,
                             const std::vector<InnerPoint>& candidates, std::size_t most,
                             double limit_m);

}  // namespace impetus::inline trees
