// Recorded trials made ready to simulate again: each with the protocol, screen and steps it had.
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "experiments/protocol/protocol_file.hpp"
#include "experiments/protocol/setting_changes.hpp"
#include "experiments/run/replay.hpp"
#include "experiments/scenes/shape_library.hpp"
#include "experiments/store/study_reader.hpp"

namespace impetus::inline study {

/// What to add to the word that the attempt diverges: nothing, unless it is of an older format.
std::string why_divergent(const StoredAttempt& attempt);

/// Makes what a replay needs of a recorded attempt: its scene at the start, and its steps.
class ReplayLibrary {
 public:
  /// `study` must outlive this. `changes` are for stage_changed().
  explicit ReplayLibrary(StudyFile& study, std::vector<SettingChange> changes = {})
      : study_(study), changes_(std::move(changes)) {}

  /// How many stimuli the attempt's trial shows: 1 or 2.
  [[nodiscard]] std::int64_t intervals(const StoredAttempt& attempt);

  /// Whether the interval showed the standard, and not the condition's own stimulus.
  [[nodiscard]] bool shows_standard(const StoredAttempt& attempt, std::int64_t interval);

  /// The scene of the attempt's interval at its start. Throws InputError when it was recorded in a
  /// format that this build does not replay, naming the build that does.
  [[nodiscard]] StagedScene stage(const StoredAttempt& attempt, std::int64_t interval = 1);

  /// The same with the changed settings. Throws InputError when it cannot be shown so.
  [[nodiscard]] StagedScene stage_changed(const StoredAttempt& attempt, std::int64_t interval = 1);

  /// Throws InputError when one of the attempt's stimuli cannot be shown with these settings.
  void check_changed(const StoredAttempt& attempt);

  [[nodiscard]] std::vector<StepRecord> steps(const StoredAttempt& attempt,
                                              std::int64_t interval = 1);

  /// From now on told while bodies are built; {}: nobody.
  void tell(Progress progress) { shapes_->tell(std::move(progress)); }

  /// A protocol of the study, as it was stored.
  const Protocol& protocol(std::int64_t id);

 private:
  /// A stimulus of an attempt, and what stages it.
  struct Stimulus {
    const Protocol* protocol{nullptr};
    PlannedTrial trial;
    double round_hold_to_hz{0.0};
  };

  [[nodiscard]] Stimulus stimulus(const StoredAttempt& attempt, std::int64_t interval);
  const nlohmann::json& changed(const StoredAttempt& attempt, const Stimulus& stimulus);

  StudyFile& study_;
  std::vector<SettingChange> changes_;
  std::map<std::string, nlohmann::json> changed_;  ///< scenes, by protocol and condition
  std::map<std::int64_t, Protocol> protocols_;
  std::shared_ptr<ShapeLibrary> shapes_ = std::make_shared<ShapeLibrary>();
};

}  // namespace impetus::inline study
