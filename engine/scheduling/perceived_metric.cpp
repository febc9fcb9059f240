// SPDX-License-Identifier: MIT
#include "engine/scheduling/perceived_metric.hpp"

#include "engine/numerics/elementary_functions.hpp"
#include "engine/scheduling/eccentricity_metric.hpp"
#include "engine/scheduling/gap_metrics.hpp"
#include "engine/scheduling/speed_metrics.hpp"
#include "engine/scheduling/visible_frequency.hpp"

namespace impetus::inline scheduling {

double noticed_threshold_arcmin(const Noticing& noticing, double eccentricity_deg,
                                double speed_deg_s) {
  return noticing.threshold_arcmin / relative_acuity(eccentricity_deg) *
         frequency_seen_at_speed(0.0) / frequency_seen_at_speed(speed_deg_s);
}

double noticed_share(const Noticing& noticing, double gap_arcmin, double threshold_arcmin) {
  if (!(gap_arcmin > 0.0)) {
    return 0.0;
  }
  return (1.0 - noticing.miss_rate) *
         cumulative_normal(log10_of(gap_arcmin / threshold_arcmin) / noticing.width_log10);
}

double noticed_threshold_arcmin(const Noticing& noticing, const PairBounds& bounds,
                                const Viewer& viewer, const Fixation& fixation,
                                const std::optional<ScreenPoint>& point) {
  return noticed_threshold_arcmin(noticing, eccentricity_deg(bounds, viewer, fixation, point),
                                  CollisionSpeedMetric().measure(bounds, viewer, fixation));
}

double PerceivedMetric::measure(const PairBounds& bounds, const Viewer& viewer,
                                const Fixation& fixation) const {
  constexpr double kArcminPerDegree = 60.0;
  const double gap_deg = spanned_by_length_deg(bounds.fit_error_m, collision_place(bounds), viewer);
  return noticed_share(noticing_, kArcminPerDegree * gap_deg,
                       noticed_threshold_arcmin(noticing_, bounds, viewer, fixation, point_));
}

}  // namespace impetus::inline scheduling
