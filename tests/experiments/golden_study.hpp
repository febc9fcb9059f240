// A golden recording, opened, with its trials made ready to simulate.
// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "experiments/protocol/protocol_scenes.hpp"
#include "experiments/protocol/solved_values.hpp"
#include "experiments/run/replay.hpp"
#include "experiments/store/step_rows.hpp"
#include "experiments/store/study_reader.hpp"
#include "tests/experiments/fakes.hpp"

namespace impetus {

/// A protocol as a recording keeps it, and its scenes.
struct GoldenProtocol {
  explicit GoldenProtocol(const ProtocolTexts& texts)
      : protocol(make_protocol(parse_json("golden protocol", texts.protocol_json),
                               parse_json("golden scene", texts.scene_json))) {}
  GoldenProtocol(const GoldenProtocol&) = delete;

  Protocol protocol;
  ProtocolScenes scenes{protocol, 0.0};
};

/// A golden study with its trials.
struct Golden {
  explicit Golden(const std::string& name = "causality")
      : study(StudyFile::open_for_reading(source_file("tests/recordings/" + name + ".sqlite"))) {}

  StudyFile study;
  std::vector<StoredAttempt> attempts{load_attempts(study)};
  std::map<std::int64_t, GoldenProtocol> protocols{};

  [[nodiscard]] const GoldenProtocol& protocol_of(const StoredAttempt& attempt) {
    const auto known = protocols.find(attempt.protocol_id);
    return known != protocols.end()
               ? known->second
               : protocols
                     .try_emplace(attempt.protocol_id,
                                  load_protocol_texts(study, attempt.protocol_id))
                     .first->second;
  }
  [[nodiscard]] StagedScene stage(const StoredAttempt& attempt) {
    const GoldenProtocol& source = protocol_of(attempt);
    const auto condition = nlohmann::json::parse(attempt.trial.condition);
    PlannedTrial planned{attempt.trial.slot, attempt.trial.phase, attempt.trial.repetition,
                         condition_from_json(condition, source.protocol.design),
                         attempt.trial.seed};
    planned.solved = solved_values_from(attempt.trial.solved);
    StagedScene scene = source.scenes.stage(planned, attempt.screen);
    scene.world.set_recording_format(attempt.recording_format);
    return scene;
  }
  [[nodiscard]] std::vector<StepRecord> steps(const StoredAttempt& attempt) {
    return load_steps(study.database(), attempt.id);
  }
};

/// What a failed replay says: it has to name trial, step, body and field.
inline std::string words(const StoredAttempt& attempt, const ReplayResult& result) {
  if (!result.divergence) {
    return "";
  }
  return "trial " + std::to_string(attempt.trial_id) + ", step " +
         std::to_string(result.divergence->step) + ", body " + result.divergence->body + ", " +
         result.divergence->field;
}

}  // namespace impetus
