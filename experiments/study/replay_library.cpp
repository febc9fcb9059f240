// SPDX-License-Identifier: MIT
#include "experiments/study/replay_library.hpp"

#include <algorithm>
#include <stdexcept>

#include "experiments/design/between_participants.hpp"
#include "experiments/protocol/checked_scene.hpp"
#include "experiments/protocol/protocol_scenes.hpp"
#include "experiments/protocol/solved_values.hpp"
#include "experiments/questions/two_interval.hpp"
#include "experiments/scenes/engine_setup.hpp"
#include "experiments/scenes/scene_file.hpp"
#include "experiments/store/step_rows.hpp"

namespace impetus::inline study {
namespace {

using nlohmann::json;

/// "study.sqlite: trial 5: expected ..."
[[noreturn]] void refuse_trial(const StudyFile& study, const StoredAttempt& attempt,
                               const std::string& sentence) {
  throw InputError(study.name() + ": trial " + std::to_string(attempt.trial_id) + ": " + sentence);
}

/// Those that the protocol's check has seen: no other scene may be built.
bool is_shown(const Design& design, const Condition& condition) {
  const std::vector<Condition> cells_shown = cells(design);
  const auto in_its_group = [&](const Condition& shown) {
    return with_group(shown, group_of(design, condition), design) == condition;
  };
  const std::vector<ConditionBeside> beside = conditions_beside(design);
  return std::find(cells_shown.begin(), cells_shown.end(), condition) != cells_shown.end() ||
         std::any_of(design.practice.begin(), design.practice.end(), in_its_group) ||
         std::any_of(beside.begin(), beside.end(),
                     [&](const ConditionBeside& each) { return in_its_group(each.condition); });
}

Condition condition_of(const StudyFile& study, const StoredAttempt& attempt,
                       const Protocol& protocol) {
  try {
    const json object = json::parse(attempt.trial.condition);
    Condition condition = condition_from_json(object, protocol.design);
    if (is_shown(protocol.design, condition)) {
      return condition;
    }
  } catch (const json::exception&) {  // not JSON, or no value of a factor: refused below
  }
  refuse_trial(
      study, attempt,
      "expected a condition of the protocol " + protocol.name + ", got " + attempt.trial.condition);
}

/// What was solved for the trial, if the scene still keeps to its schema with it.
std::vector<SolvedValue> solved_of(const StudyFile& study, const StoredAttempt& attempt,
                                   const Protocol& protocol, const Condition& condition) {
  if (attempt.trial.solved.empty()) {
    return {};
  }
  try {
    std::vector<SolvedValue> solved = solved_values_from(attempt.trial.solved);
    json scene = scene_under(protocol, condition);
    put_into_scene(solved, scene);
    if (!find_scene_schema_problem(scene)) {
      return solved;
    }
  } catch (const json::exception&) {  // refused below
  }
  refuse_trial(study, attempt, "expected solved values of its scene, got " + attempt.trial.solved);
}

/// Without its condition.
PlannedTrial planned(const StoredAttempt& attempt) {
  return {
      attempt.trial.slot, attempt.trial.phase, attempt.trial.repetition, {}, attempt.trial.seed};
}

void require_screen(const StudyFile& study, const StoredAttempt& attempt) {
  const ScreenGeometry& screen = attempt.screen;
  constexpr double kMost_m = 1000.0;
  for (const double length_m : {screen.width_m, screen.height_m, screen.viewing_distance_m}) {
    if (!(length_m > 0.0 && length_m <= kMost_m)) {
      refuse_trial(study, attempt,
                   "expected a screen with sides and a viewing distance above 0 m, got " +
                       std::to_string(length_m) + " m");
    }
  }
}

}  // namespace

std::string why_divergent(const StoredAttempt& attempt) {
  return attempt.recording_format == kRecordingFormat
             ? ""
             : "; it was recorded in format " + std::to_string(attempt.recording_format) + " by " +
                   attempt.build + ": replay it there as well";
}

std::int64_t ReplayLibrary::intervals(const StoredAttempt& attempt) {
  return interval_count(protocol(attempt.protocol_id).script, planned(attempt));
}

bool ReplayLibrary::shows_standard(const StoredAttempt& attempt, std::int64_t interval) {
  return interval != test_interval(protocol(attempt.protocol_id).script, planned(attempt));
}

ReplayLibrary::Stimulus ReplayLibrary::stimulus(const StoredAttempt& attempt,
                                                std::int64_t interval) {
  if (!is_tried(attempt.recording_format)) {
    throw InputError(study_.name() + ": trial " + std::to_string(attempt.trial_id) +
                     " was recorded in format " + std::to_string(attempt.recording_format) +
                     " by " + attempt.build + "; this build replays formats " +
                     std::to_string(kOldestRecordingFormat) + " to " +
                     std::to_string(kRecordingFormat) + ", use that one");
  }
  const Protocol& source = protocol(attempt.protocol_id);
  require_screen(study_, attempt);
  PlannedTrial trial = planned(attempt);
  trial.condition = condition_of(study_, attempt, source);
  trial.solved = solved_of(study_, attempt, source, trial.condition);
  return {&source, stimuli_of(source.script, trial).at(static_cast<std::size_t>(interval - 1)),
          attempt.rounding_allowed ? attempt.refresh_hz : 0.0};
}

StagedScene ReplayLibrary::stage(const StoredAttempt& attempt, std::int64_t interval) {
  const Stimulus shown = stimulus(attempt, interval);
  StagedScene scene =
      ProtocolScenes(*shown.protocol, shown.round_hold_to_hz).stage(shown.trial, attempt.screen);
  scene.world.set_recording_format(attempt.recording_format);
  return scene;
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
  StagedScene staged = staged_from(shown.protocol->scene, [&] {
    return build_scene(scene, attempt.screen, shown.round_hold_to_hz, *shapes_,
                       start_of(shown.trial), shown.trial.seed, deepest);
  });
  staged.world.set_recording_format(attempt.recording_format);
  return staged;
}

void ReplayLibrary::check_changed(const StoredAttempt& attempt) {
  for (std::int64_t interval = 1; interval <= intervals(attempt); ++interval) {
    static_cast<void>(changed(attempt, stimulus(attempt, interval)));
  }
}

std::vector<StepRecord> ReplayLibrary::steps(const StoredAttempt& attempt, std::int64_t interval) {
  try {
    return load_steps(study_.database(), attempt.id, interval);
  } catch (const std::invalid_argument& error) {
    refuse_trial(study_, attempt, error.what());
  }
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
                                 parse_json(place + ", scene", texts.scene_json), shapes_))
      .first->second;
}

}  // namespace impetus::inline study
