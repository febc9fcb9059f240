// Few spheres that cover many points and reach as little beyond a solid as they can.
//
//   expand    every candidate ball grows by one common stand-off; the fewest that cover the points
//             are picked greedily; the stand-off is halved in on (Bradshaw and O'Sullivan 2004)
//   exchange  one pick for another candidate, while that makes stand-off times outside volume less
//   refine    each point goes to the sphere that needs the smallest stand-off for it, each centre
//             moves to where its own points need the smallest; repeated (after Wang et al. 2006)
//
// Points only: whoever needs a surface covered grows the spheres afterwards.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "engine/shapes/surface_distance.hpp"
#include "engine/trees/builders/medial_balls.hpp"
#include "engine/volumes/sphere.hpp"

namespace impetus::inline trees {

/// Centres, and the common stand-off: spheres of radius depth + stand-off cover all points.
struct SphereCover {
  std::vector<InnerPoint> centres;
  double stand_off_m{0.0};
};

/// The spheres of a cover, with its common stand-off.
std::vector<Sphere> spheres_of(const SphereCover& cover);

/// At most `most` centres among, and then near, `candidates`. Preconditions: a point and a
/// candidate or more.
SphereCover cover_points(const SurfaceDistance& surface, const OutsidePoints& outside,
                         const std::vector<Vector3>& points,
                         const std::vector<InnerPoint>& candidates, std::size_t most);

/// The same without the exchange and in fewer rounds: for many spheres, whose number alone says
/// how well a part can be covered.
SphereCover cover_points_quickly(const SurfaceDistance& surface, const std::vector<Vector3>& points,
                                 const std::vector<InnerPoint>& candidates, std::size_t most);

/// Which points each centre of the cover stands for: those for which it needs the least stand-off.
std::vector<std::vector<Vector3>> clusters(const std::vector<InnerPoint>& centres,
                                           const std::vector<Vector3>& points);

/// The centre near `start` from which a sphere round `points` reaches least beyond the solid.
InnerPoint best_centre(const SurfaceDistance& surface, const std::vector<Vector3>& points,
                       const InnerPoint& start);

/// The centre near `start` of the sphere round `points` with the least volume outside the solid
/// that keeps to `stand_off`; `start` itself keeps to it.
InnerPoint leanest_centre(const SurfaceDistance& surface, const OutsidePoints& outside,
                          const std::vector<Vector3>& points, const InnerPoint& start,
                          double stand_off);

/// The stand-off that a sphere about `centre` needs to hold all of `points`.
double stand_off_m(const InnerPoint& centre, const std::vector<Vector3>& points);

}  // namespace impetus::inline trees
