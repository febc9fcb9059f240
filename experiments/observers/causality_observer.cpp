// A simulated participant of the causality study: belief in the collision falls with its delay.
//
//   seen = Φ((τ − μ_i) / σ)
//
// τ is the freeze that was really shown; μ_i belongs to the participant. The parameters are in
// experiments/observers/causality.json.
// SPDX-License-Identifier: MIT
#include "experiments/observers/observer_kinds.hpp"
#include "experiments/observers/shown_truths.hpp"

namespace impetus::inline observers {

const ObserverKind& causality_observer();

namespace {

/// What a participant of the causality study is made of.
struct CausalityParameters : RatingParameters {
  double threshold_mean_ms{0.0};  ///< μ over participants
  double threshold_sd_ms{0.0};
  double threshold_width_ms{1.0};  ///< σ of the psychometric function
};

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

/// The longest freeze of all that was shown.
Percept shown_delay(const RatingParameters& /*parameters*/, const AttemptRecord& shown,
                    const StagedScene& /*scene*/) {
  return {longest_delay_ms(shown)};
}

double seen_delay(const RatingParameters& parameters, const Traits& traits,
                  const Percept& percept) {
  const auto& own = static_cast<const CausalityParameters&>(parameters);
  const double threshold_ms = own.threshold_mean_ms + own.threshold_sd_ms * traits.threshold;
  return normal_cdf((percept[0] - threshold_ms) / own.threshold_width_ms);
}

AnswerModel causality_answers() {
  AnswerModel answers = answers_of_own<CausalityParameters, causality_entries>(
      {"threshold_mean_ms", "threshold_width_ms", "guess_rate", "miss_rate"},
      {{"threshold_sd_ms", &Traits::threshold}});
  answers.percept = shown_delay;
  answers.seen = seen_delay;
  return answers;
}

}  // namespace

const ObserverKind& causality_observer() {
  static const ObserverKind kind{.name = "causality",
                                 .words = "Notices a delay at contact.",
                                 .attention = {"the delay at contact", {"contact_hold"}},
                                 .parameters = list_own<CausalityParameters, causality_entries>(),
                                 .read = read_own<CausalityParameters, causality_entries>,
                                 .make = make_modelled<causality_observer>,
                                 .answers = causality_answers()};
  return kind;
}

}  // namespace impetus::inline observers
