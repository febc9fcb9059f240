// SPDX-License-Identifier: MIT
#include "engine/scheduling/visible_frequency.hpp"

#include "engine/numerics/elementary_functions.hpp"
#include "engine/scheduling/eccentricity_metric.hpp"
#include "engine/scheduling/speed_metrics.hpp"

namespace impetus::inline scheduling {

double frequency_seen_at_speed(double speed_deg_s) {
  constexpr double kSlowest_deg_s = 0.825;
  constexpr double kFastest_deg_s = 118.3;
  if (speed_deg_s <= kSlowest_deg_s) {
    return 60.0;
  }
  return speed_deg_s <= kFastest_deg_s ? 57.69 - 27.78 * log10_of(speed_deg_s) : 0.1;
}

double share_seen_at_eccentricity(double eccentricity_deg) {
  constexpr double kFovea_deg = 5.79;
  if (eccentricity_deg <= kFovea_deg) {
    return 1.0;
  }
  const double falling = 0.3 * eccentricity_deg + 1.0;
  return 7.49 / (falling * falling);
}

double VisibleFrequencyMetric::measure(const PairBounds& bounds, const Viewer& viewer,
                                       const Fixation& fixation) const {
  return frequency_seen_at_speed(mean_seen_speed_deg_s(bounds, viewer)) *
         share_seen_at_eccentricity(eccentricity_deg(bounds, viewer, fixation, point_));
}

}  // namespace impetus::inline scheduling
