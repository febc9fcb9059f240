// Collisions of large bodies first. (Dingliana 2002, sec. 5.2.1)
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "engine/numerics/elementary_functions.hpp"
#include "engine/scheduling/priority.hpp"

namespace impetus::inline scheduling {

/// Degrees that the two bounds' diameters span at the eye, mean.
class SizeMetric final : public PriorityMetric {
 public:
  SizeMetric() : PriorityMetric(Urgent::kLarge) {}
  [[nodiscard]] unsigned terms() const override { return 0; }
  [[nodiscard]] double measure(const PairBounds& bounds, const Viewer& viewer,
                               const Fixation& /*fixation*/) const override {
    return 0.5 * (spanned_deg(bounds.a, viewer) + spanned_deg(bounds.b, viewer));
  }

 private:
  /// The angle between opposite tangents from the eye: 2 asin(R / d).
  static double spanned_deg(const Sphere& sphere, const Viewer& viewer) {
    const double square = (sphere.centre - viewer.eye).squaredNorm();
    const double tangent_square = square - sphere.radius_m * sphere.radius_m;
    return tangent_square > 0.0
               ? degrees(2.0 * atan2_rad(sphere.radius_m, std::sqrt(tangent_square)))
               : 180.0;
  }
};

}  // namespace impetus::inline scheduling
