// SPDX-License-Identifier: MIT
#include "experiments/observers/gap_observer.hpp"

#include <algorithm>
#include <cmath>

#include "engine/numerics/elementary_functions.hpp"
#include "experiments/run/collision_truth.hpp"

namespace impetus::inline observers {

GapObserver::GapObserver(const GapParameters& parameters, std::uint64_t seed,
                         const std::string& pseudonym, VirtualClock& clock,
                         const std::string& study)
    : RatingObserver(parameters, RandomStream(seed, "observer/" + study + "/" + pseudonym), clock),
      parameters_(parameters) {
  draw_traits();
  if (parameters_.threshold_sd_log10 > 0.0) {
    threshold_log10_ = parameters_.threshold_sd_log10 * normal();
  }
}

double GapObserver::threshold_arcmin(double eccentricity_deg, double speed_deg_s,
                                     std::size_t bodies) const {
  const double crowd = std::max(0.0, static_cast<double>(bodies) - 2.0);
  return gap_threshold_arcmin(parameters_.threshold_arcmin, eccentricity_deg, speed_deg_s) *
         std::pow(10.0, threshold_log10_) * (1.0 + parameters_.crowding_per_body * crowd);
}

double GapObserver::seen_gap(double visible_arcmin, double eccentricity_deg, double speed_deg_s,
                             std::size_t bodies) const {
  if (visible_arcmin <= 0.0) {
    return parameters_.guess_rate;
  }
  const double threshold = threshold_arcmin(eccentricity_deg, speed_deg_s, bodies);
  return parameters_.guess_rate +
         (1.0 - parameters_.guess_rate - parameters_.miss_rate) *
             normal_cdf(std::log10(visible_arcmin / threshold) / parameters_.width_log10);
}

double GapObserver::seen(const AttemptRecord& shown, const StagedScene& scene) {
  const double m_per_deg = metres_per_degree(scene.viewer.screen.viewing_distance_m);
  double clearest = parameters_.guess_rate;
  for (const CollisionRecord& collision : shown.collisions) {
    if (is_wall(collision.report.bodies.b)) {
      continue;
    }
    const auto a = static_cast<std::size_t>(collision.report.bodies.a);
    const auto b = static_cast<std::size_t>(collision.report.bodies.b);
    const CollisionTruth truth =
        measure_truth(scene.looks[a], collision.pose_a, scene.looks[b], collision.pose_b,
                      scene.viewer_at_time(collision.time_s));
    const double speed_deg_s = collision.report.approach_m_s / m_per_deg;
    clearest = std::max(clearest, seen_gap(truth.visible_arcmin(), collision.eccentricity_deg,
                                           speed_deg_s, scene.looks.size()));
  }
  return clearest;
}

}  // namespace impetus::inline observers
