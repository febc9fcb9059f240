// SPDX-License-Identifier: MIT
#include "experiments/scenes/showing/sound_settings.hpp"

#include "experiments/scenes/engine_setup.hpp"
#include "experiments/scenes/scene.hpp"
#include "experiments/scenes/scene_problems.hpp"

namespace impetus::inline scenes {
namespace {

const Names<SoundKind>& sound_names() {
  static const Names<SoundKind> names{{"none", SoundKind::kNone},     {"wood", SoundKind::kWood},
                                      {"metal", SoundKind::kMetal},   {"glass", SoundKind::kGlass},
                                      {"rubber", SoundKind::kRubber}, {"tone", SoundKind::kTone}};
  return names;
}

/// Whether steps follow from the scene alone, so that its contacts are known before it is shown.
bool can_be_foreseen(const Scene& scene) {
  const bool by_time = scene.engine.budget && scene.engine.budget->ms_per_step;
  return !by_time && !depends_on_gaze(scene.engine);
}

}  // namespace

Kind<SoundTask> sound_kind() {
  using S = SoundTask;
  return object<S>(
      "A sound at the scene's contacts; it changes no step.",
      {required("kind", &S::kind, choice(sound_names()),
                "wood, metal, glass, rubber: what is struck, as damped modes of a bar (Klatzky, "
                "Pai and Krotkov 2000); tone: a sine; none: silence, as a factor's level."),
       row("lag_ms", &S::lag_ms, number({-1000, 1000}),
           "From the flip that shows the contact to the sound's onset; below 0 it comes first. 0 "
           "when left out."),
       row("loudness", &S::loudness, number(above(0, 1)),
           "Of the first contact: share of what the sound device can give; 0.5 when left out."),
       row("frequency_hz", &S::frequency_hz, number({50, 16000}), "Of a tone; 1000 when left out."),
       row("duration_ms", &S::duration_ms, number({1, 5000}), "Of a tone; 100 when left out."),
       row("every_contact", &S::is_of_every_contact, flag(),
           "true: each contact sounds, louder and softer than the first by its impulse. false, "
           "when left out: the first alone."),
       row("at_s", &S::at_s, number({0, 3600}),
           "From onset, in place of contacts: where bodies pass through each other.")});
}

void add_sound_problems(const Scene& scene, SceneProblems& problems) {
  if (!scene.sound) {
    return;
  }
  const SoundTask& sound = *scene.sound;
  if (sound.at_s && sound.is_of_every_contact) {
    problems.add("/sound/at_s", "expected none beside every_contact");
  }
  if (sound.lag_ms < 0.0 && !sound.at_s && !can_be_foreseen(scene)) {
    problems.add_got("/sound/lag_ms",
                     "expected 0 or more where the gaze or a budget in milliseconds decides the "
                     "steps, for nobody knows such a contact before it comes");
  }
}

}  // namespace impetus::inline scenes
