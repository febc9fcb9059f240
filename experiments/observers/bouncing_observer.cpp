// A simulated participant who sees two discs bounce or stream, by the sound that goes with it.
//
//   P(bounce) = λ/2 + (1 − λ) (s + (b − s) exp(−((L − c) / w)² / 2))      L: the sound's lag
//
// Without a sound it is λ/2 + (1 − λ) s. (After Sekuler, Sekuler and Lau 1997)
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "experiments/observers/observer_kinds.hpp"

namespace impetus::inline observers {

const ObserverKind& bouncing_observer();

namespace {

/// What he is made of.
struct BouncingParameters : RatingParameters {
  double silent{0.2};
  double silent_sd{0.0};
  double with_sound{0.7};
  double centre_ms{0.0};
  double width_ms{150.0};
};

std::vector<ParameterEntry> bouncing_entries(BouncingParameters& own) {
  return with_answering_entries(
      own,
      {{"silent", 0.0, 1.0, &own.silent, "How often it is a bounce without a sound."},
       {"silent_sd", 0.0, 1.0, &own.silent_sd, "Spread of that between participants."},
       {"with_sound", 0.0, 1.0, &own.with_sound, "How often with a sound at its best lag."},
       {"centre_ms", -1000.0, 1000.0, &own.centre_ms, "The best lag; below 0 the sound is first."},
       {"width_ms", 1.0, 5000.0, &own.width_ms,
        "How far from it sounds still count: a standard deviation."}});
}

/// Goes by the lag that the scene asks for.
class BouncingObserver final : public RatingObserver {
 public:
  BouncingObserver(const BouncingParameters& parameters, const Birth& birth)
      : RatingObserver(parameters, birth, "bouncing"), own_(parameters) {
    silent_ = std::clamp(own_.silent + own_.silent_sd * normal(), 0.0, 1.0);
  }

 private:
  [[nodiscard]] double seen(const AttemptRecord& /*shown*/, const StagedScene& scene) override {
    if (!scene.sound || scene.sound->kind == SoundKind::kNone) {
      return silent_;
    }
    const double far = (scene.sound->lag_ms - own_.centre_ms) / own_.width_ms;
    return silent_ + (own_.with_sound - silent_) * std::exp(-0.5 * far * far);
  }

  BouncingParameters own_;
  double silent_{0.0};
};

}  // namespace

const ObserverKind& bouncing_observer() {
  static const ObserverKind kind{
      .name = "bouncing",
      .words = "Sees two discs bounce rather than stream, the nearer a sound is to their meeting.",
      .attention = {"when a sound is heard", {"sound/lag", "sound/kind"}},
      .parameters = list_of<BouncingParameters, bouncing_entries>(),
      .read = read_with<BouncingParameters, bouncing_entries, answer_blindly_by_lapses>,
      .make = make_own<BouncingParameters, BouncingObserver>,
      .has_own_scale = true};
  return kind;
}

}  // namespace impetus::inline observers
