// SPDX-License-Identifier: MIT
#include "experiments/observers/causality_observer.hpp"

#include <algorithm>

namespace impetus::inline observers {

CausalityObserver::CausalityObserver(const CausalityParameters& parameters, std::uint64_t seed,
                                     const std::string& pseudonym, VirtualClock& clock)
    : RatingObserver(parameters, RandomStream(seed, "observer/causality/" + pseudonym), clock),
      threshold_ms_(parameters.threshold_mean_ms + parameters.threshold_sd_ms * normal()),
      width_ms_(parameters.threshold_width_ms) {
  draw_traits();
}

double CausalityObserver::seen_at(double delay_ms) const {
  return normal_cdf((delay_ms - threshold_ms_) / width_ms_);
}

double CausalityObserver::seen(const AttemptRecord& shown, const StagedScene& /*scene*/) {
  double delay_ms = 0.0;
  for (const CollisionRecord& collision : shown.collisions) {
    delay_ms = std::max(delay_ms, 1e3 * collision.report.imposed_hold_s);
  }
  return seen_at(delay_ms);
}

}  // namespace impetus::inline observers
