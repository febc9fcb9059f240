// Replays studies with little more than the engine, scenes and the reader of studies, so that other
// compilers build it in a minute: replay_recordings STUDY... Protocols are trusted, not checked.
//
//   study ─> protocol and scene as texts ─ condition, solved values put in ─> world ─> hashes
//
// SPDX-License-Identifier: MIT
#include <cstdio>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>

#include "experiments/questions/level_value.hpp"
#include "experiments/questions/response_kinds.hpp"
#include "experiments/run/replay.hpp"
#include "experiments/scenes/scene_file.hpp"
#include "experiments/store/step_rows.hpp"
#include "experiments/store/study_reader.hpp"

namespace impetus {
namespace {

using nlohmann::json;

void put_values(const json& values, json& scene) {
  for (auto value = values.begin(); value != values.end(); ++value) {
    scene[json::json_pointer(value.key())] = value.value();
  }
}

/// The scene of a trial, as ProtocolScenes makes it.
json scene_of(const ProtocolTexts& texts, const StoredTrial& trial) {
  json scene = json::parse(texts.scene_json);
  const json design = json::parse(texts.protocol_json)["design"];
  const json condition = json::parse(trial.condition);
  for (const json& factor : design["factors"]) {
    const json& level = condition[factor["name"].get<std::string>()];
    if (factor.contains("pointer")) {
      scene[json::json_pointer(factor["pointer"].get<std::string>())] = to_json(level_value(level));
    }
    if (factor.contains("sets")) {
      put_values(factor["sets"][level.get<std::string>()], scene);
    }
  }
  if (!trial.solved.empty()) {
    put_values(json::parse(trial.solved), scene);
  }
  return scene;
}

StagedScene staged(const ProtocolTexts& texts, const StoredAttempt& attempt, ShapeLibrary& shapes) {
  const bool practice = attempt.trial.phase == TrialPhase::kPractice;
  StagedScene scene =
      build_scene(scene_of(texts, attempt.trial), attempt.screen, /*round_hold_to_hz=*/0.0, shapes,
                  (practice ? "practice/" : "main/") + std::to_string(attempt.trial.repetition),
                  attempt.trial.seed);
  scene.world.set_recording_format(attempt.recording_format);
  return scene;
}

/// Whether every trial of the study ends each step in the state that it did.
bool replays(const char* file) {
  StudyFile study = StudyFile::open_for_reading(file);
  ShapeLibrary shapes;
  std::map<std::int64_t, ProtocolTexts> texts;
  std::int64_t steps = 0;
  for (const StoredAttempt& attempt : load_attempts(study)) {
    if (!texts.contains(attempt.protocol_id)) {
      texts[attempt.protocol_id] = load_protocol_texts(study, attempt.protocol_id);
    }
    const ReplayResult result = replay(staged(texts[attempt.protocol_id], attempt, shapes),
                                       load_steps(study.database(), attempt.id, 1));
    steps += result.steps;
    if (result.divergence) {
      std::printf("%s: trial %lld diverges at step %lld, body %s, %s\n", file,
                  static_cast<long long>(attempt.trial_id),
                  static_cast<long long>(result.divergence->step), result.divergence->body.c_str(),
                  result.divergence->field.c_str());
      return false;
    }
  }
  std::printf("%s: %lld steps, the same bits\n", file, static_cast<long long>(steps));
  return steps > 0;
}

}  // namespace
}  // namespace impetus

int main(int count, char** words) {
  bool all = count > 1;
  for (int i = 1; i < count; ++i) {
    all = impetus::replays(words[i]) && all;
  }
  return all ? 0 : 1;
}
