// A simulated participant who judges what would have happened without the other body, and how much
// he therefore mattered, by running the rest of the clip in his own head: see imagined_runs.hpp.
//
//   would it have got through?     p, the share of imagined runs
//   what did he do to it?          (1 if it got through, else 0) − p: −1 prevented ... 1 caused
//
// (Gerstenberg, Goodman, Lagnado and Tenenbaum 2021)
// SPDX-License-Identifier: MIT
#include "experiments/observers/counterfactual_observer.hpp"

#include <algorithm>
#include <cmath>

namespace impetus::inline observers {

const ObserverKind& counterfactual_observer();

namespace {

std::vector<ParameterEntry> counterfactual_entries(CounterfactualParameters& own) {
  return {{"heading_noise_deg", 0.0, 90.0, &own.heading_noise_deg,
           "Standard deviation of the turn of the imagined heading in each imagined step."},
          {"runs", 1.0, 1e6, &own.runs, "Imagined runs for each clip."},
          {"step_hz", 1.0, 10000.0, &own.step_hz, "Imagined steps a second."},
          {"level", -1.0, 30.0, &own.level,
           "The deepest level of detail imagined; -1, when left out: as the scene has it.", true},
          {"tests_per_step", -1.0, kAny, &own.tests_per_step,
           "Units of work in an imagined step; -1, when left out: no limit.", true},
          {"mark_sd", 0.0, 1.0, &own.mark_sd,
           "Standard deviation of a mark from what is meant, as a share of the line from nothing "
           "to everything."},
          {"lapse_rate", 0.0, 1.0, &own.lapse_rate, "The share of answers that are anything."},
          {"reaction_median_ms", 0.0, kAny, &own.reaction_median_ms,
           "Median of the times from question to answer, which are lognormal."},
          {"reaction_sigma_log", 0.0, kAny, &own.reaction_sigma_log,
           "Standard deviation of the natural logarithm of these times."}};
}

std::shared_ptr<const RatingParameters> read_counterfactual(const JsonDocument& document) {
  auto own = std::make_shared<CounterfactualParameters>();
  read_numbers(document, counterfactual_entries(*own), {}, nullptr);
  own->yes_guess_rate = 0.5 * own->lapse_rate;
  own->yes_miss_rate = 0.5 * own->lapse_rate;
  return own;
}

/// Imagines each clip anew.
class CounterfactualObserver final : public RatingObserver {
 public:
  CounterfactualObserver(const CounterfactualParameters& parameters, const Birth& birth)
      : RatingObserver(parameters, birth, "counterfactual"),
        own_(parameters),
        draws_(birth.seed, "observer/counterfactual/" + birth.pseudonym) {}

  double mark() override { return marked(foreseen_.without, 0.0); }
  double two_sided_mark() override {
    return marked((foreseen_.through ? 1.0 : 0.0) - foreseen_.without, -1.0);
  }

 private:
  [[nodiscard]] double seen(const AttemptRecord& /*shown*/, const StagedScene& scene) override {
    foreseen_ = scene.goal ? foresee(scene, own_.imagination(), draws_) : Foresight{};
    return foreseen_.without;
  }

  /// With the hand's noise, or anywhere on the line.
  double marked(double meant, double least) {
    return uniform() < own_.lapse_rate
               ? draw_between(draws_, least, 1.0)
               : std::clamp(meant + own_.mark_sd * draw_normal(draws_), least, 1.0);
  }

  CounterfactualParameters own_;
  RandomStream draws_;
  Foresight foreseen_;
};

}  // namespace

Imagination CounterfactualParameters::imagination() const {
  Imagination by{static_cast<std::int64_t>(runs), heading_noise_deg, step_hz};
  if (level >= 0.0) {
    by.level = static_cast<int>(level);
  }
  if (tests_per_step >= 0.0) {
    by.tests_per_step = static_cast<std::int64_t>(tests_per_step);
  }
  return by;
}

Foresight foresee(const StagedScene& scene, const Imagination& by, RandomStream& draws) {
  Foresight foresight;
  foresight.through = gets_through(scene);
  const std::optional<Meeting> meeting = first_meeting(scene);
  if (!meeting) {
    foresight.without = foresight.through ? 1.0 : 0.0;
    return foresight;
  }
  foresight.other = meeting->other;
  foresight.without = imagined_share(scene, *meeting, by, draws);
  return foresight;
}

const ObserverKind& counterfactual_observer() {
  static CounterfactualParameters nobody;
  static const ObserverKind kind{
      .name = "counterfactual",
      .words =
          "Runs the rest of a clip in its own engine without the other body, again and again, "
          "and answers by the share of runs in which the goal's body gets through.",
      .attention = {"where the bodies are and where they go", {"position", "velocity", "shape"}},
      .parameters = counterfactual_entries(nobody),
      .read = read_counterfactual,
      .make = make_own<CounterfactualParameters, CounterfactualObserver>,
      .has_own_scale = true,
      .effect_is_of_all = false};
  return kind;
}

}  // namespace impetus::inline observers
