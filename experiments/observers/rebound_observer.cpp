// A simulated participant who notices that two bodies part otherwise than they should (O'Sullivan,
// Dingliana, Giang and Kaiser 2003).
//
//   seen = 1 − (1 − F(angle)) (1 − F(speed)),   F(x) = Φ((log₁₀(x / t) − s · z_i) / width)
//
// What is imposed has a threshold t of its own for each direction: ways that are wider apart or
// closer together, more speed or less. z_i belongs to the participant. What physics
// makes of a contact never looks wrong. The parameters are in
// experiments/observers/distorted-rebounds.json.
// SPDX-License-Identifier: MIT
#include <cmath>

#include "engine/numerics/elementary_functions.hpp"
#include "experiments/observers/observer_kinds.hpp"
#include "experiments/observers/shown_truths.hpp"

namespace impetus::inline observers {

const ObserverKind& rebound_observer();

namespace {

/// What a participant of the study of rebounds is made of.
struct ReboundParameters : RatingParameters {
  double wider_deg{0.0};
  double narrower_deg{0.0};
  double faster_percent{0.0};
  double slower_percent{0.0};
  double width_log10{0.2};
  double threshold_sd_log10{0.0};  ///< over participants
};

std::vector<ParameterEntry> rebound_entries(ReboundParameters& own) {
  return {{"threshold_wider_deg", 1e-3, kAny, &own.wider_deg,
           "What the angle between two ways gains where that is noticed half of the time."},
          {"threshold_narrower_deg", 1e-3, kAny, &own.narrower_deg,
           "What it loses where that is noticed half of the time."},
          {"threshold_faster_percent", 1e-3, kAny, &own.faster_percent,
           "What both speeds gain where that is noticed half of the time."},
          {"threshold_slower_percent", 1e-3, kAny, &own.slower_percent,
           "What they lose where that is noticed half of the time."},
          {"width_log10", 1e-3, kAny, &own.width_log10,
           "How wide the functions are: a standard deviation of the decimal logarithm."},
          {"threshold_sd_log10", 0.0, kAny, &own.threshold_sd_log10,
           "Spread between participants of the decimal logarithm of all thresholds together."},
          {"guess_rate", 0.0, 1.0, &own.yes_guess_rate, "Yes where nothing is noticed."},
          {"miss_rate", 0.0, 1.0, &own.yes_miss_rate, "No where it is clearly noticed."}};
}

/// What was imposed on the angle (degrees) and on the speeds (percent) of bodies that met.
Percept shown_rebound(const RatingParameters& /*parameters*/, const AttemptRecord& shown,
                      const StagedScene& scene) {
  const auto& rebound = scene.world.settings().imposed_rebound;
  if (!rebound || first_meeting(shown) == nullptr) {
    return {0.0, 0.0};
  }
  return {rebound->wider_deg, 100.0 * (rebound->speed_ratio - 1.0)};
}

double seen_rebound(const RatingParameters& parameters, const Traits& traits,
                    const Percept& percept) {
  const auto& own = static_cast<const ReboundParameters&>(parameters);
  const auto missed = [&](double change, double of_more, double of_less) {
    if (change == 0.0) {
      return 1.0;
    }
    const double threshold_log10 =
        std::log10(change > 0.0 ? of_more : of_less) + own.threshold_sd_log10 * traits.threshold;
    return 1.0 - normal_cdf((std::log10(std::abs(change)) - threshold_log10) / own.width_log10);
  };
  return 1.0 - missed(percept[0], own.wider_deg, own.narrower_deg) *
                   missed(percept[1], own.faster_percent, own.slower_percent);
}

AnswerModel rebound_answers() {
  AnswerModel answers = answers_of_own<ReboundParameters, rebound_entries>(
      {"threshold_wider_deg", "threshold_narrower_deg", "threshold_faster_percent",
       "threshold_slower_percent", "width_log10", "guess_rate", "miss_rate"},
      {{"threshold_sd_log10", &Traits::threshold}});
  answers.percept = shown_rebound;
  answers.seen = seen_rebound;
  return answers;
}

}  // namespace

const ObserverKind& rebound_observer() {
  static const ObserverKind kind{
      .name = "rebound",
      .words =
          "Notices that two bodies part too far apart, too close together, too fast or slowly.",
      .attention = {"how two bodies part after they met", {"rebound"}},
      .parameters = list_own<ReboundParameters, rebound_entries>(),
      .read = read_own<ReboundParameters, rebound_entries>,
      .make = make_modelled<rebound_observer>,
      .answers = rebound_answers()};
  return kind;
}

}  // namespace impetus::inline observers
