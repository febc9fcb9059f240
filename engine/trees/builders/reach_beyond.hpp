// How far a volume seems to reach beyond an object: measured at points, for choosing among fits.
// The certified bound is NodeDescription's.
//
// Signed distances for this are exact, or between remembered ones of a grid, which is a hundred
// times quicker and good where a volume is many cells wide.
// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <vector>

#include "engine/shapes/surface_distance.hpp"
#include "engine/volumes/volume.hpp"

namespace impetus::inline trees {

/// Distances to one solid, remembered on a grid.
class RoughDistance {
 public:
  /// Refers to `exact`. The grid has about `cells` along the longest side of `bounds` and
  /// reaches a little beyond; the distance at a point of it is asked for when it is
  /// first needed.
  RoughDistance(const SurfaceDistance& exact, const Bounds& bounds, int cells);

  /// Interpolated between the eight points of the grid about `point` (metres), off by less than
  /// spacing_m(); exact outside the grid.
  [[nodiscard]] double interpolated_m(const Vector3& point) const;

  [[nodiscard]] double spacing_m() const { return spacing_m_; }
  [[nodiscard]] const SurfaceDistance& exact() const { return *exact_; }

 private:
  [[nodiscard]] double at(const Eigen::Vector3i& index) const;

  const SurfaceDistance* exact_;
  Vector3 least_;
  double spacing_m_;
  Eigen::Vector3i counts_;              ///< points along each side
  mutable std::vector<float> known_m_;  ///< not a number where nobody has asked
};

/// Either of the two, for volumes of a given size.
class DistanceToUse {
 public:
  /// Exact always.
  explicit DistanceToUse(const RoughDistance& rough) : rough_(&rough), exact_(true) {}

  /// Interpolated for parts more than six cells wide.
  DistanceToUse(const RoughDistance& rough, double extent_m)
      : rough_(&rough), exact_(extent_m < 6.0 * rough.spacing_m()) {}

  [[nodiscard]] double signed_distance_m(const Vector3& point) const {
    return exact_ ? rough_->exact().signed_distance_m(point) : rough_->interpolated_m(point);
  }

 private:
  const RoughDistance* rough_;
  bool exact_;
};

/// How finely a reach is measured, and where to stop.
struct ReachSettings {
  int most_questions{120};  ///< distances asked for, corners not counted
  double enough_m{std::numeric_limits<double>::infinity()};
};

/// Metres, never negative: the greatest signed distance to the solid from points on the faces of a
/// box; for swept volumes the radius plus the greatest along the core, more than the truth where
/// the nearest surface lies askew. Faces are halved where they might hold a greater distance, to
/// within 2 % or 1e-3 of the volume's size, as long as questions last. Any value above `enough_m`
/// may be returned once it is known to be exceeded.
double reach_beyond_m(const Volume& volume, const DistanceToUse& solid,
                      const ReachSettings& settings = {});

}  // namespace impetus::inline trees
