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

double seen_delay(const CausalityParameters& own, const Traits& traits, double delay_ms) {
  const double threshold_ms = own.threshold_mean_ms + own.threshold_sd_ms * traits.threshold;
  return normal_cdf((delay_ms - threshold_ms) / own.threshold_width_ms);
}

AnswerModel causality_answers() {
  AnswerModel answers = answers_of_own<CausalityParameters, causality_entries>(
      {"threshold_mean_ms", "threshold_width_ms", "guess_rate", "miss_rate"},
      {{"threshold_sd_ms", &Traits::threshold}});
  answers.percept = [](const RatingParameters& /*parameters*/, const AttemptRecord& shown,
                       const StagedScene& /*scene*/) -> Percept {
    return {longest_delay_ms(shown)};
  };
  answers.seen = [](const RatingParameters& parameters, const Traits& traits,
                    const Percept& percept) {
    return seen_delay(static_cast<const CausalityParameters&>(parameters), traits, percept[0]);
  };
  return answers;
}

}  // namespace

CausalityObserver::CausalityObserver(const CausalityParameters& parameters, const Birth& birth)
    : RatingObserver(parameters, birth, "causality"), parameters_(parameters) {
  traits_.threshold = normal();
  draw_traits();
}

double CausalityObserver::seen_at(double delay_ms) const {
  return seen_delay(parameters_, traits_, delay_ms);
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
                                 .make = make_own<CausalityParameters, CausalityObserver>,
                                 .answers = causality_answers()};
  return kind;
}

}  // namespace impetus::inline observers
