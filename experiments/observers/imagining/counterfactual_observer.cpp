// A simulated participant who judges what would have happened without the other body, and how much
// he therefore mattered, by running the rest of the clip in his own head: see imagined_runs.hpp.
//
//   would it have got through?     p, the share of imagined runs
//   what did he do to it?          (1 if it got through, else 0) − p: −1 prevented ... 1 caused
//
// (Gerstenberg, Goodman, Lagnado and Tenenbaum 2021)
// SPDX-License-Identifier: MIT
#include "experiments/observers/imagining/counterfactual_observer.hpp"

#include <algorithm>
#include <cmath>

#include "engine/dynamics/state_hash.hpp"
#include "experiments/observers/imagining/noise_ladder.hpp"

namespace impetus::inline observers {

const ObserverKind& counterfactual_observer();

namespace {

std::vector<ParameterEntry> counterfactual_entries(CounterfactualParameters& own) {
  return imagining_entries(own, {{"mark_sd", 0.0, 1.0, &own.mark_sd,
                                  "Standard deviation of a mark from what is meant, as a share of "
                                  "the line from nothing to everything."}});
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

/// As marked() draws it: the share of this participant's own runs, the hand's noise, and lapses.
double counterfactual_mark(const RatingParameters& parameters, double seen, const Mark& mark) {
  const auto& own = static_cast<const CounterfactualParameters&>(parameters);
  const double sd = std::sqrt(own.mark_sd * own.mark_sd + seen * (1.0 - seen) / own.runs);
  return (1.0 - own.lapse_rate) * mark_chance(mark, seen, sd) +
         own.lapse_rate * mark_chance_anywhere(mark);
}

AnswerModel counterfactual_answers() {
  AnswerModel answers = imagining_answers<CounterfactualParameters, counterfactual_entries>();
  answers.fitted.emplace_back("mark_sd");
  answers.mark = counterfactual_mark;
  answers.happened = [](const StagedScene& scene) {
    return scene.goal && gets_through(scene) ? 1.0 : 0.0;
  };
  answers.percept = [](const RatingParameters& parameters, const AttemptRecord& /*shown*/,
                       const StagedScene& scene) {
    return shares_by_noise(static_cast<const CounterfactualParameters&>(parameters),
                           hash_state(scene.start).hash,
                           [&](const Imagination& by, RandomStream& draws) {
                             return scene.goal ? foresee(scene, by, draws).without : 0.0;
                           });
  };
  return answers;
}

}  // namespace

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
  static const ObserverKind kind{
      .name = "counterfactual",
      .words =
          "Runs the rest of a clip in its own engine without the other body, again and again, "
          "and answers by the share of runs in which the goal's body gets through.",
      .attention = {"where the bodies are and where they go", {"position", "velocity", "shape"}},
      .parameters = list_of<CounterfactualParameters, counterfactual_entries>(),
      .read = read_with<CounterfactualParameters, counterfactual_entries, answer_blindly_by_lapses>,
      .make = make_own<CounterfactualParameters, CounterfactualObserver>,
      .has_own_scale = true,
      .answers = counterfactual_answers()};
  return kind;
}

}  // namespace impetus::inline observers
