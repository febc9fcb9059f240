// SPDX-License-Identifier: MIT
#include "experiments/scenes/showing/sound_settings.hpp"

#include <memory>
#include <stdexcept>

#include "experiments/models/base64.hpp"
#include "experiments/models/mesh_bytes.hpp"
#include "experiments/scenes/engine_setup.hpp"
#include "experiments/scenes/scene.hpp"
#include "experiments/scenes/scene_problems.hpp"

namespace impetus::inline scenes {

using nlohmann::json;

namespace {

const Names<SoundKind>& sound_names() {
  static const Names<SoundKind> names{{"none", SoundKind::kNone},     {"wood", SoundKind::kWood},
                                      {"metal", SoundKind::kMetal},   {"glass", SoundKind::kGlass},
                                      {"rubber", SoundKind::kRubber}, {"file", SoundKind::kFile},
                                      {"tone", SoundKind::kTone}};
  return names;
}

/// Whether steps follow from the scene alone, so that its contacts are known before it is shown.
bool can_be_foreseen(const Scene& scene) {
  const bool by_time = scene.engine.budget && scene.engine.budget->ms_per_step;
  return !by_time && !depends_on_gaze(scene.engine);
}

/// Throws std::runtime_error for what content_of() does not make.
std::shared_ptr<const SoundSamples> samples_of(const SoundContent& content) {
  const std::string bytes = bytes_from_base64(content.base64);
  if (bytes.empty() || bytes.size() % sizeof(float) != 0) {
    throw std::runtime_error("expected samples of 32 bits, got " + std::to_string(bytes.size()) +
                             " bytes");
  }
  ByteReader reader(bytes);
  auto samples = std::make_shared<SoundSamples>();
  samples->rate_hz = content.rate_hz;
  while (reader.left() > 0) {
    samples->values.push_back(reader.take<float>());
  }
  return samples;
}

/// Adds what is wrong with the file that is to be heard.
void add_file_problems(const Scene& scene, SceneProblems& problems) {
  const std::string& file = scene.sound->file;
  if (file.empty()) {
    problems.add_missing("/sound", "file", "for kind file");
    return;
  }
  const auto content = scene.sound_files.find(file);
  if (content == scene.sound_files.end()) {
    problems.add_got("/sound/file", "expected a file that was read with the scene");
    return;
  }
  try {
    static_cast<void>(samples_of(content->second));
  } catch (const std::runtime_error& error) {
    problems.add("/sound_files", file + ": " + error.what());
  }
}

}  // namespace

Kind<SoundTask> sound_kind() {
  using Task = SoundTask;
  return object<Task>(
      "A sound at the scene's contacts; it changes no step.",
      {required(
           "kind", &Task::kind, choice(sound_names()),
           "wood, metal, glass, rubber: what is struck, as damped modes of a bar (Klatzky, "
           "Pai and Krotkov 2000); tone: a sine; file: a recording; none: silence, as a factor's "
           "level."),
       row("file", &Task::file, text(),
           "Of kind file: WAV, FLAC or OGG, up to 5 s, seen from the scene's folder and within it. "
           "What it holds is played at this loudness, as loud as it is."),
       row("lag_ms", &Task::lag_ms, number({-1000, 1000}),
           "From the flip that shows the contact to the sound's onset; below 0 it comes first. 0 "
           "when left out."),
       row("loudness", &Task::loudness, number(above(0, 1)),
           "Of the first contact: share of what the sound device can give; 0.5 when left out."),
       row("frequency_hz", &Task::frequency_hz, number({50, 16000}),
           "Of a tone; 1000 when left out."),
       row("duration_ms", &Task::duration_ms, number({1, 5000}), "Of a tone; 100 when left out."),
       row("every_contact", &Task::is_of_every_contact, flag(),
           "true: each contact sounds, louder and softer than the first by its impulse. false, "
           "when left out: the first alone."),
       row("at_s", &Task::at_s, number({0, 3600}),
           "From onset, in place of contacts: where bodies pass through each other.")});
}

Kind<SoundContent> sound_content_kind() {
  using Content = SoundContent;
  return object<Content>("", {required("rate_hz", &Content::rate_hz, number({1, 1e6})),
                              required("base64", &Content::base64, any_text(),
                                       "Samples, mono (32-bit floating point), little-endian.")});
}

std::optional<std::string> named_sound_file(const Scene& scene) {
  return scene.sound && !scene.sound->file.empty() ? std::optional(scene.sound->file)
                                                   : std::nullopt;
}

json content_of(const SoundSamples& samples) {
  std::string bytes;
  for (const float value : samples.values) {
    append_number(bytes, value);
  }
  return {{"rate_hz", samples.rate_hz}, {"base64", base64(bytes)}};
}

std::optional<SoundTask> sound_of(const Scene& scene) {
  std::optional<SoundTask> sound = scene.sound;
  if (sound && sound->kind == SoundKind::kFile) {
    sound->samples = samples_of(scene.sound_files.at(sound->file));
  }
  return sound;
}

void add_sound_problems(const Scene& scene, SceneProblems& problems) {
  if (!scene.sound) {
    return;
  }
  const SoundTask& sound = *scene.sound;
  if (sound.kind == SoundKind::kFile) {
    add_file_problems(scene, problems);
  }
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
