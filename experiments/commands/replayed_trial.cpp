// SPDX-License-Identifier: MIT
#include "experiments/commands/replayed_trial.hpp"

#include <algorithm>

#include "build_info.hpp"
#include "experiments/protocol/deepest_level.hpp"
#include "experiments/protocol/protocol_scenes.hpp"
#include "experiments/protocol/solved_values.hpp"
#include "experiments/protocol/trial_scene.hpp"
#include "experiments/scenes/scene_file.hpp"
#include "experiments/scenes/scene_schedule.hpp"
#include "experiments/session/intervals.hpp"
#include "experiments/store/step_rows.hpp"

namespace impetus {

std::string why_divergent(const StoredAttempt& attempt) {
  return attempt.recording_format == kRecordingFormat
             ? ""
             : "; it was recorded in format " + std::to_string(attempt.recording_format) + " by " +
                   attempt.build + ": replay it there as well";
}

std::int64_t ReplayLibrary::intervals(const StoredAttempt& attempt) {
  return protocol(attempt.protocol_id).script.two_interval ? 2 : 1;
}

bool ReplayLibrary::shows_standard(const StoredAttempt& attempt, std::int64_t interval) {
  PlannedTrial trial;
  trial.seed = attempt.trial.seed;
  return interval != test_interval(protocol(attempt.protocol_id).script, trial);
}

ReplayLibrary::Stimulus ReplayLibrary::stimulus(const StoredAttempt& attempt,
                                                std::int64_t interval) {
  if (attempt.recording_format < kOldestRecordingFormat ||
      attempt.recording_format > kRecordingFormat) {
    throw InputError(study_.name() + ": trial " + std::to_string(attempt.trial_id) +
                     " was recorded in format " + std::to_string(attempt.recording_format) +
                     " by " + attempt.build + "; this build replays formats " +
                     std::to_string(kOldestRecordingFormat) + " to " +
                     std::to_string(kRecordingFormat) + ", use that one");
  }
  const Protocol& source = protocol(attempt.protocol_id);
  const auto condition = nlohmann::json::parse(attempt.trial.condition);
  PlannedTrial planned{attempt.trial.slot, attempt.trial.phase, attempt.trial.repetition,
                       condition_from_json(condition, source.design), attempt.trial.seed};
  planned.solved = solved_values_from(attempt.trial.solved);
  return {&source, stimuli_of(source.script, planned)[static_cast<std::size_t>(interval - 1)],
          attempt.rounding_allowed ? attempt.refresh_hz : 0.0};
}

StagedScene ReplayLibrary::stage(const StoredAttempt& attempt, std::int64_t interval) {
  const Stimulus shown = stimulus(attempt, interval);
  return ProtocolScenes(*shown.protocol, shown.round_hold_to_hz, shapes_)
      .stage(shown.trial, attempt.screen);
}

const nlohmann::json& ReplayLibrary::changed(const StoredAttempt& attempt,
                                             const Stimulus& stimulus) {
  const std::string key = std::to_string(attempt.protocol_id) +
                          to_json(stimulus.trial.condition).dump() + to_text(stimulus.trial.solved);
  const auto known = changed_.find(key);
  if (known != changed_.end()) {
    return known->second;
  }
  return changed_
      .emplace(key, changed_scene(scene_of(*stimulus.protocol, stimulus.trial), changes_))
      .first->second;
}

StagedScene ReplayLibrary::stage_changed(const StoredAttempt& attempt, std::int64_t interval) {
  const Stimulus shown = stimulus(attempt, interval);
  const nlohmann::json& scene = changed(attempt, shown);
  // As deep as the study's own, so that its own settings give its own trees.
  const int deepest =
      std::max(deepest_level_of(*shown.protocol), deepest_level_of(scene["engine"]));
  return build_scene(scene, attempt.screen, shown.round_hold_to_hz, *shapes_, start_of(shown.trial),
                     shown.trial.seed, deepest);
}

void ReplayLibrary::check_changed(const StoredAttempt& attempt) {
  for (std::int64_t interval = 1; interval <= intervals(attempt); ++interval) {
    static_cast<void>(changed(attempt, stimulus(attempt, interval)));
  }
}

std::vector<StepRecord> ReplayLibrary::steps(const StoredAttempt& attempt, std::int64_t interval) {
  return load_steps(study_.database(), attempt.id, interval);
}

const Protocol& ReplayLibrary::protocol(std::int64_t id) {
  const auto known = protocols_.find(id);
  if (known != protocols_.end()) {
    return known->second;
  }
  const ProtocolTexts texts = load_protocol_texts(study_, id);
  const std::string place = study_.name() + ", protocol " + texts.name;
  return protocols_
      .emplace(id, make_protocol(parse_json(place, texts.protocol_json),
                                 parse_json(place + ", scene", texts.scene_json)))
      .first->second;
}

}  // namespace impetus
