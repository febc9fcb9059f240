// A simulated participant who says what will happen after a scene is hidden, by running the rest of
// it in his own head: see imagined_runs.hpp.
//
//   will the two that flashed touch?     yes with the share of imagined runs in which they do
//
// Whoever flashed is who is asked about; where no two did, nothing is seen.
// SPDX-License-Identifier: MIT
#include "engine/dynamics/state_hash.hpp"
#include "experiments/observers/imagining/noise_ladder.hpp"

namespace impetus::inline observers {

const ObserverKind& foreseeing_observer();

namespace {

std::vector<ParameterEntry> foreseeing_entries(ImaginingParameters& own) {
  return imagining_entries(own);
}

/// In how many runs the two touch that flashed; none: no two did.
double foreseen_share(const StagedScene& scene, const Imagination& by, RandomStream& draws) {
  const std::vector<std::size_t>& meant = scene.flashing.bodies;
  if (meant.size() != 2) {
    return 0.0;
  }
  const BodyPair pair{static_cast<std::int32_t>(meant[0]), static_cast<std::int32_t>(meant[1])};
  return imagined_touching(scene, last_shown_instant(scene), pair, by, draws);
}

/// Imagines each clip anew.
class ForeseeingObserver final : public RatingObserver {
 public:
  ForeseeingObserver(const ImaginingParameters& parameters, const Birth& birth)
      : RatingObserver(parameters, birth, "foreseeing"),
        imagination_(parameters.imagination()),
        draws_(birth.seed, "observer/foreseeing/" + birth.pseudonym) {}

 private:
  [[nodiscard]] double seen(const AttemptRecord& /*shown*/, const StagedScene& scene) override {
    return foreseen_share(scene, imagination_, draws_);
  }

  Imagination imagination_;
  RandomStream draws_;
};

AnswerModel foreseeing_answers() {
  AnswerModel answers = imagining_answers<ImaginingParameters, foreseeing_entries>();
  answers.percept = [](const RatingParameters& parameters, const AttemptRecord& /*shown*/,
                       const StagedScene& scene) {
    return shares_by_noise(static_cast<const ImaginingParameters&>(parameters),
                           hash_state(scene.start).hash,
                           [&](const Imagination& by, RandomStream& draws) {
                             return foreseen_share(scene, by, draws);
                           });
  };
  return answers;
}

}  // namespace

const ObserverKind& foreseeing_observer() {
  static const ObserverKind kind{
      .name = "foreseeing",
      .words =
          "Runs the hidden rest of a clip in its own engine, again and again, and answers by the "
          "share of runs in which the two bodies that flashed touch.",
      .attention = {"where the bodies are and where they go", {"position", "velocity", "shape"}},
      .parameters = list_of<ImaginingParameters, foreseeing_entries>(),
      .read = read_with<ImaginingParameters, foreseeing_entries, answer_blindly_by_lapses>,
      .make = make_own<ImaginingParameters, ForeseeingObserver>,
      .has_own_scale = true,
      .answers = foreseeing_answers()};
  return kind;
}

}  // namespace impetus::inline observers
