// Collisions that could leave a large gap between the drawn surfaces first.
//
//   gap            the thesis's rough measure: between the centres of the two bounds
//   gap-bound      what the gap cannot exceed: both trees' fit errors, for a point of two nodes
//                  that overlap lies within each tree's error of that tree's surface
//   projected-gap  the visual angle of the bound at the place of the collision
//   projected-centres  the visual angle between the two centres, the rough measure projected
//
// (Dingliana 2002, sec. 5.2.1 and footnote 1 of sec. 6.3.2)
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/numerics/elementary_functions.hpp"
#include "engine/scheduling/priority.hpp"

namespace impetus::inline scheduling {

/// Metres between the centres of the two bounding spheres; zero for a body and a wall.
class GapMetric final : public PriorityMetric {
 public:
  GapMetric() : PriorityMetric(Urgent::kLarge) {}
  [[nodiscard]] unsigned terms() const override { return 0; }
  [[nodiscard]] double measure(const PairBounds& bounds, const Viewer& /*viewer*/,
                               const Fixation& /*fixation*/) const override {
    return (bounds.a.centre - bounds.b.centre).norm();
  }
};

/// Metres, at the level that the pair stands at when it is measured.
class GapBoundMetric final : public PriorityMetric {
 public:
  GapBoundMetric() : PriorityMetric(Urgent::kLarge) {}
  [[nodiscard]] unsigned terms() const override { return kFitErrorTerm; }
  [[nodiscard]] double measure(const PairBounds& bounds, const Viewer& /*viewer*/,
                               const Fixation& /*fixation*/) const override {
    return bounds.fit_error_m;
  }
};

/// The visual angle of a length across the line of sight at `place` (degrees).
inline double spanned_by_length_deg(double length_m, const Vector3& place, const Viewer& viewer) {
  const double distance_m = (place - viewer.eye).norm();
  return degrees(2.0 * atan2_rad(0.5 * length_m, distance_m));
}

/// Measures the visual angle that two bounds may reach beyond their surfaces.
class ProjectedGapMetric final : public PriorityMetric {
 public:
  ProjectedGapMetric() : PriorityMetric(Urgent::kLarge) {}
  [[nodiscard]] unsigned terms() const override { return kFitErrorTerm; }
  [[nodiscard]] double measure(const PairBounds& bounds, const Viewer& viewer,
                               const Fixation& /*fixation*/) const override {
    return spanned_by_length_deg(bounds.fit_error_m, collision_place(bounds), viewer);
  }
};

/// Degrees between the two centres as the eye sees them: gap on the image plane, foreshortening
/// counted. Zero for a body and a wall.
class ProjectedCentresMetric final : public PriorityMetric {
 public:
  ProjectedCentresMetric() : PriorityMetric(Urgent::kLarge) {}
  [[nodiscard]] unsigned terms() const override { return 0; }
  [[nodiscard]] double measure(const PairBounds& bounds, const Viewer& viewer,
                               const Fixation& /*fixation*/) const override {
    return visual_angle_deg(viewer, bounds.a.centre, bounds.b.centre);
  }
};

}  // namespace impetus::inline scheduling
