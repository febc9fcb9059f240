// The sound of a scene's contacts, as its file says it.
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "experiments/record/sound.hpp"
#include "experiments/settings/setting_rows.hpp"

namespace impetus::inline scenes {

struct Scene;
class SceneProblems;

/// Of `/sound`.
Kind<SoundTask> sound_kind();

/// The content of a sound file, put into the scene when it is read.
struct SoundContent {
  double rate_hz{48000.0};
  std::string base64;  ///< 32-bit floating point, little-endian
};
Kind<SoundContent> sound_content_kind();

/// The file that the scene names; none: it names none.
std::optional<std::string> named_sound_file(const Scene& scene);

/// The content of samples, as JSON.
nlohmann::json content_of(const SoundSamples& samples);

/// What is to be heard, with the samples of its file; none: nothing. Precondition:
/// add_sound_problems() adds none.
std::optional<SoundTask> sound_of(const Scene& scene);

/// Adds what is wrong with it: a sound before a contact that cannot be foreseen, a contact where
/// nothing touches, a time after the end.
void add_sound_problems(const Scene& scene, SceneProblems& problems);

}  // namespace impetus::inline scenes
