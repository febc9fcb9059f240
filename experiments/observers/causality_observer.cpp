// SPDX-License-Identifier: MIT
#include "experiments/observers/causality_observer.hpp"

#include "experiments/observers/shown_truths.hpp"

namespace impetus::inline observers {
namespace {

std::vector<ParameterEntry> causality_entries(CausalityParameters& own) {
  return {{"threshold_mean_ms", -kAny, kAny, &own.threshold_mean_ms,
           "The delay at contact that is seen half of the time, ms."},
          {"threshold_sd_ms", 0.0, kAny, &own.threshold_sd_ms,
           "Spread of that threshold between participants."},
          {"threshold_width_ms", 1e-3, kAny, &own.threshold_width_ms,
           "How wide the function is: a standard deviation."},
          {"guess_rate", 0.0, 1.0, &own.yes_guess_rate, "Yes where nothing is seen.", true},
          {"miss_rate", 0.0, 1.0, &own.yes_miss_rate, "No where it is clearly seen.", true}};
}

}  // namespace

CausalityObserver::CausalityObserver(const CausalityParameters& parameters, const Birth& birth)
    : RatingObserver(parameters, birth, "causality"),
      threshold_ms_(parameters.threshold_mean_ms + parameters.threshold_sd_ms * normal()),
      width_ms_(parameters.threshold_width_ms) {
  draw_traits();
}

double CausalityObserver::seen_at(double delay_ms) const {
  return normal_cdf((delay_ms - threshold_ms_) / width_ms_);
}

double CausalityObserver::seen(const AttemptRecord& shown, const StagedScene& /*scene*/) {
  return seen_at(longest_delay_ms(shown));
}

const ObserverKind& causality_observer() {
  static const ObserverKind kind{.name = "causality",
                                 .words = "Notices a delay at contact.",
                                 .attention = {"the delay at contact", {"contact_hold"}},
                                 .parameters = list_own<CausalityParameters, causality_entries>(),
                                 .read = read_own<CausalityParameters, causality_entries>,
                                 .make = make_own<CausalityParameters, CausalityObserver>};
  return kind;
}

}  // namespace impetus::inline observers
