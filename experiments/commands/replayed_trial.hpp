// Recorded trials made ready to simulate again: each with the protocol, screen and steps it had.
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "experiments/protocol/protocol_file.hpp"
#include "experiments/scenes/shape_library.hpp"
#include "experiments/session/replay.hpp"
#include "experiments/store/study_reader.hpp"

namespace impetus {

/// What to add to the word that the attempt diverges: nothing, unless it is of an older format.
std::string why_divergent(const StoredAttempt& attempt);

class ReplayLibrary {
 public:
  /// `study` must outlive this.
  explicit ReplayLibrary(StudyFile& study) : study_(study) {}

  /// How many stimuli the attempt's protocol shows in a trial: 1 or 2.
  [[nodiscard]] std::int64_t intervals(const StoredAttempt& attempt);

  /// Whether the interval showed the standard, and not the condition's own stimulus.
  [[nodiscard]] bool shows_standard(const StoredAttempt& attempt, std::int64_t interval);

  /// The scene of the attempt's interval at its start. Throws InputError when it was recorded in a
  /// format that this build does not replay, naming the build that does.
  [[nodiscard]] StagedScene stage(const StoredAttempt& attempt, std::int64_t interval = 1);

  [[nodiscard]] std::vector<StepRecord> steps(const StoredAttempt& attempt,
                                              std::int64_t interval = 1);

  /// A protocol of the study, as it was stored.
  const Protocol& protocol(std::int64_t id);

 private:
  StudyFile& study_;
  std::map<std::int64_t, Protocol> protocols_;
  std::shared_ptr<ShapeLibrary> shapes_ = std::make_shared<ShapeLibrary>();
};

}  // namespace impetus
