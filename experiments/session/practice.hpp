// Whether a participant has understood the task, judged by a round of practice, or by how many of
// the last trials were answered right.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "experiments/questions/script.hpp"
#include "experiments/record/record.hpp"

namespace impetus::inline session {

/// What a participant did in one practice trial.
struct PracticeResult {
  Condition condition;
  std::optional<std::int64_t> rating{};  ///< none: not asked for, or the time was up
  std::int64_t clicks{0};
  std::optional<bool> right{};  ///< none: there is no right answer
};

/// What the record of a completed trial says of it.
PracticeResult practice_result(const Condition& condition, const AttemptRecord& record);

/// What is still missing, in words for the participant; empty when the round was understood.
std::vector<std::string> missing_in_practice(const PracticeRule& rule, const Script& script,
                                             const std::vector<PracticeResult>& round);

/// How many of the last `of` trials, in the order they were made, were answered right.
std::int64_t right_of_last(std::int64_t of, const std::vector<PracticeResult>& results);

/// Whether training is over after these trials.
bool is_trained(const TrainingRule& rule, const std::vector<PracticeResult>& results);

}  // namespace impetus::inline session
