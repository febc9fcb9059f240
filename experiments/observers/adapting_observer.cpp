// A simulated participant who sees one disc launch another, or pass it by: the more the two overlap
// when the first stops, the rather it is a pass; and launches that were seen wear off.
//
//   P(launch) = λ/2 + (1 − λ) Φ((μ_i − d a − o) / σ)      o: the overlap, as a share of the second
//   a ← a + r (1 − a) with each launch that is shown, a ← a (1 − f) with anything else
//
// μ_i belongs to the participant, d is how far full adaptation moves him. What is a launch to him
// adapts him, whether it was asked about or not. (After Rolfs, Dambacher and Cavanagh 2013)
// SPDX-License-Identifier: MIT

#include "experiments/observers/observer_kinds.hpp"
#include "experiments/observers/shown_truths.hpp"

namespace impetus::inline observers {

const ObserverKind& adapting_observer();

namespace {

/// What he is made of.
struct AdaptingParameters : RatingParameters {
  double overlap_threshold{0.5};
  double overlap_threshold_sd{0.0};
  double overlap_width{0.1};
  double shift{0.0};
  double rate{0.0};
  double fading{0.0};
};

std::vector<ParameterEntry> adapting_entries(AdaptingParameters& own) {
  return with_answering_entries(
      own,
      {{"overlap_threshold", -1.0, 2.0, &own.overlap_threshold,
        "The overlap that is as often a launch as a pass, a share of the second's width."},
       {"overlap_threshold_sd", 0.0, 2.0, &own.overlap_threshold_sd,
        "Spread of that overlap between participants."},
       {"overlap_width", 1e-3, 2.0, &own.overlap_width,
        "How wide its function is: a standard deviation."},
       {"shift", -2.0, 2.0, &own.shift,
        "How much less overlap is a pass when launches have worn off altogether."},
       {"rate", 0.0, 1.0, &own.rate, "Of what is left of that, the share that a launch takes."},
       {"fading", 0.0, 1.0, &own.fading,
        "The share of adaptation that goes with anything else that is shown."}});
}

/// Judges how far the first stopped over the second, by what was seen before.
class AdaptingObserver final : public RatingObserver {
 public:
  AdaptingObserver(const AdaptingParameters& parameters, const Birth& birth)
      : RatingObserver(parameters, birth, "adapting"), own_(parameters) {
    threshold_ = own_.overlap_threshold + own_.overlap_threshold_sd * normal();
  }

 private:
  [[nodiscard]] double seen(const AttemptRecord& /*shown*/, const StagedScene& scene) override {
    if (!scene.launch) {
      return 0.0;
    }
    const double overlap = -scene.launch->gap_deg / scene.launch->second_width_deg;
    const double launch =
        normal_cdf((threshold_ - own_.shift * adaptation_ - overlap) / own_.overlap_width);
    adaptation_ +=
        launch * own_.rate * (1.0 - adaptation_) - (1.0 - launch) * own_.fading * adaptation_;
    return launch;
  }

  AdaptingParameters own_;
  double threshold_{0.0};
  double adaptation_{0.0};  ///< a, from 0 to 1
};

}  // namespace

const ObserverKind& adapting_observer() {
  static const ObserverKind kind{
      .name = "adapting",
      .words = "Sees one disc launch another or pass it by, and less of launches the more it saw.",
      .attention = {"how far the first stops over the second", {"launch/gap", "position"}},
      .parameters = list_of<AdaptingParameters, adapting_entries>(),
      .read = read_with<AdaptingParameters, adapting_entries, answer_blindly_by_lapses>,
      .make = make_own<AdaptingParameters, AdaptingObserver>,
      .has_own_scale = true};
  return kind;
}

}  // namespace impetus::inline observers
