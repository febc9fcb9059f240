// The levels and answers of adaptive trials, kept and read back.
// SPDX-License-Identifier: MIT
#pragma once

#include <SQLiteCpp/Database.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "experiments/design/plan.hpp"
#include "experiments/record/record.hpp"

namespace impetus::inline store {

class StudyFile;

/// Completes a planned trial's condition by its chosen level. Throws SQLite::Exception when it has
/// one already.
void update_chosen_level(SQLite::Database& database, std::int64_t trial_id,
                         const ChosenLevel& chosen);

/// By slot, the answers to an enrolment's completed adaptive trials that count for a threshold.
std::map<std::int64_t, bool> load_counted_answers(SQLite::Database& database,
                                                  std::int64_t enrolment);

/// An adaptive trial whose level was chosen.
struct StoredAdaptiveTrial {
  std::int64_t trial_id{0};
  std::string participant;
  std::int64_t protocol_id{0};
  std::int64_t enrolment_id{0};
  std::int64_t slot{0};
  std::int64_t track{0};
  std::string condition;  ///< JSON text
  std::string state;      ///< JSON text
  bool completed{false};
  std::optional<bool> counted_answer{};
};

/// All of a study, enrolment by enrolment, in the order in which their levels were chosen.
std::vector<StoredAdaptiveTrial> load_adaptive_trials(StudyFile& study);

}  // namespace impetus::inline store
