// Whether a participant has understood the task, judged by a round of practice.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "experiments/session/script.hpp"

namespace impetus {

/// What a participant did in one practice trial.
struct PracticeResult {
  Condition condition;
  std::int64_t rating{0};
  std::int64_t clicks{0};
};

/// What is still missing, in words for the participant; empty when the round was understood.
std::vector<std::string> missing_in_practice(const PracticeRule& rule, const Script& script,
                                             const std::vector<PracticeResult>& round);

}  // namespace impetus
