// A simulated participant who sees one body launch another (Michotte 1963): the impression that the
// first made the second move breaks when it moves too late, or from too far away.
//
//   seen = 1 − (1 − Φ((τ − μ_i) / σ)) (1 − Φ((g − ν) / ω))
//
// τ is the freeze, g the gap, as they were really shown; μ_i belongs to the participant. What is
// rated is the impression: the better, the less is seen.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <optional>

#include "experiments/observers/observer_kinds.hpp"
#include "experiments/observers/shown_truths.hpp"

namespace impetus::inline observers {

const ObserverKind& launching_observer();

namespace {

/// What a participant of the launching study is made of.
struct LaunchingParameters : RatingParameters {
  double delay_threshold_ms{0.0};  ///< μ over participants
  double delay_threshold_sd_ms{0.0};
  double delay_width_ms{1.0};
  double gap_threshold_arcmin{0.0};
  double gap_width_arcmin{1.0};
  double level{-1.0};
  double mark_sd{0.1};
};

std::vector<ParameterEntry> launching_entries(LaunchingParameters& own) {
  return {
      {"delay_threshold_ms", -kAny, kAny, &own.delay_threshold_ms,
       "The delay at contact that breaks the impression half of the time, ms."},
      {"delay_threshold_sd_ms", 0.0, kAny, &own.delay_threshold_sd_ms,
       "Spread of that threshold between participants."},
      {"delay_width_ms", 1e-3, kAny, &own.delay_width_ms,
       "How wide its function is: a standard deviation."},
      {"gap_threshold_arcmin", -kAny, kAny, &own.gap_threshold_arcmin,
       "The gap that breaks the impression half of the time."},
      {"gap_width_arcmin", 1e-3, kAny, &own.gap_width_arcmin,
       "How wide its function is: a standard deviation."},
      {"level", -1.0, 30.0, &own.level,
       "Of an imposed launch, the level of the bodies' trees at which the gap is seen; -1, when "
       "left out: of the outlines.",
       true},
      {"mark_sd", 0.0, 1.0, &own.mark_sd,
       "Standard deviation of a mark on a line from what is meant, as a share of the line; 0.1 "
       "when left out.",
       true}};
}

/// Of all that was shown: the longest freeze (ms) and the widest gap (minutes of arc).
Percept shown_launch(const RatingParameters& parameters, const AttemptRecord& shown,
                     const StagedScene& scene) {
  const double level = static_cast<const LaunchingParameters&>(parameters).level;
  const double gap_arcmin = !scene.launch ? widest_gap_arcmin(shown, scene)
                            : level < 0.0 ? launch_gap_arcmin(scene, std::nullopt)
                                          : launch_gap_arcmin(scene, static_cast<int>(level));
  return {scene.launch ? 1e3 * scene.launch->hold_s : longest_delay_ms(shown),
          std::max(0.0, gap_arcmin)};
}

double seen_launch(const RatingParameters& parameters, const Traits& traits,
                   const Percept& percept) {
  const auto& own = static_cast<const LaunchingParameters&>(parameters);
  const double delay_ms = own.delay_threshold_ms + own.delay_threshold_sd_ms * traits.threshold;
  const double late = normal_cdf((percept[0] - delay_ms) / own.delay_width_ms);
  const double apart = normal_cdf((percept[1] - own.gap_threshold_arcmin) / own.gap_width_arcmin);
  return 1.0 - (1.0 - late) * (1.0 - apart);
}

/// The mark that is meant is the impression.
double launching_mark(const RatingParameters& parameters, double seen, const Mark& mark) {
  return mark_chance(mark, 1.0 - seen, static_cast<const LaunchingParameters&>(parameters).mark_sd);
}

AnswerModel launching_answers() {
  AnswerModel answers = answers_of_own<LaunchingParameters, launching_entries>(
      {"delay_threshold_ms", "gap_threshold_arcmin", "delay_width_ms", "gap_width_arcmin",
       "mark_sd"},
      {{"delay_threshold_sd_ms", &Traits::threshold}});
  answers.percept = shown_launch;
  answers.seen = seen_launch;
  answers.mark = launching_mark;
  return answers;
}

/// Marks a line with the noise of a hand.
class LaunchingObserver final : public ModelledObserver {
 public:
  using ModelledObserver::ModelledObserver;

  double mark() override {
    const double sd = static_cast<const LaunchingParameters&>(parameters()).mark_sd;
    return std::clamp(1.0 - clearest() + sd * normal(), 0.0, 1.0);
  }
};

}  // namespace

const ObserverKind& launching_observer() {
  static const ObserverKind kind{
      .name = "launching",
      .words = "Sees one body launch another, unless late or from afar.",
      .attention = {"the delay at contact and the gap there", {"contact_hold", "gap"}},
      .parameters = list_own<LaunchingParameters, launching_entries>(),
      .read = read_own<LaunchingParameters, launching_entries>,
      .make = make_modelled<launching_observer, LaunchingObserver>,
      .answers = launching_answers()};
  return kind;
}

}  // namespace impetus::inline observers
