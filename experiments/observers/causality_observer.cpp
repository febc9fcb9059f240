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

const ObserverKind& causality_observer() {
  static const ObserverKind kind{
      .name = "causality",
      .read = [](const JsonDocument& document) -> std::shared_ptr<const RatingParameters> {
        auto read = std::make_shared<CausalityParameters>();
        read_parameters(document, *read,
                        {{"threshold_mean_ms", -kAny, kAny, &read->threshold_mean_ms},
                         {"threshold_sd_ms", 0.0, kAny, &read->threshold_sd_ms},
                         {"threshold_width_ms", 1e-3, kAny, &read->threshold_width_ms},
                         {"guess_rate", 0.0, 1.0, &read->yes_guess_rate, true},
                         {"miss_rate", 0.0, 1.0, &read->yes_miss_rate, true}});
        return read;
      },
      .make = [](const RatingParameters& parameters,
                 const Birth& birth) -> std::unique_ptr<RatingObserver> {
        return std::make_unique<CausalityObserver>(
            static_cast<const CausalityParameters&>(parameters), birth.seed, birth.pseudonym,
            birth.clock);
      }};
  return kind;
}

}  // namespace impetus::inline observers
