// SPDX-License-Identifier: MIT
#include "experiments/observers/response_observer.hpp"

#include <algorithm>
#include <cmath>

#include "engine/numerics/elementary_functions.hpp"

namespace impetus::inline observers {
namespace {

/// How fast a body turns at the end of what was shown.
double spin_deg_s(const StagedScene& scene, std::int32_t body) {
  const auto index = static_cast<std::size_t>(body);
  return degrees(angular_velocity(scene.world.models()[index], scene.world.states()[index]).norm());
}

}  // namespace

ResponseObserver::ResponseObserver(const ResponseParameters& parameters, std::uint64_t seed,
                                   const std::string& pseudonym, VirtualClock& clock)
    : GapObserver(parameters, seed, pseudonym, clock, "response"), parameters_(parameters) {}

double ResponseObserver::seen_of(double seen_gap, double spin_deg_s, double closing_deg_s) const {
  const double turning = spin_deg_s > 0.0
                             ? normal_cdf(std::log10(spin_deg_s / parameters_.spin_median_deg_s) /
                                          parameters_.spin_width_log10)
                             : 0.0;
  const double haste = 1.0 - std::exp(-closing_deg_s / parameters_.speed_scale_deg_s);
  return 1.0 - (1.0 - seen_gap) * (1.0 - parameters_.spin_weight * (1.0 - turning)) *
                   (1.0 - parameters_.speed_weight * haste);
}

double ResponseObserver::seen(const AttemptRecord& shown, const StagedScene& scene) {
  const double gap = GapObserver::seen(shown, scene);
  const auto met = std::find_if(
      shown.collisions.begin(), shown.collisions.end(),
      [](const CollisionRecord& collision) { return !is_wall(collision.report.bodies.b); });
  if (met == shown.collisions.end()) {
    return gap;
  }
  const BodyPair& bodies = met->report.bodies;
  const double m_per_deg = metres_per_degree(scene.viewer.screen.viewing_distance_m);
  return seen_of(gap, 0.5 * (spin_deg_s(scene, bodies.a) + spin_deg_s(scene, bodies.b)),
                 met->report.approach_m_s / m_per_deg);
}

}  // namespace impetus::inline observers
