// SPDX-License-Identifier: MIT
#include "experiments/store/adaptive_rows.hpp"

#include <sqlite3.h>

#include "experiments/questions/level_value.hpp"
#include "experiments/store/rows.hpp"
#include "experiments/store/study_file.hpp"

namespace impetus::inline store {
namespace {

/// The answer of an attempt that counts: its first that is positive or negative.
constexpr const char* kCountedAnswerSql =
    "(SELECT positive FROM response WHERE response.attempt_id = attempt.id "
    "AND positive IS NOT NULL ORDER BY response.number LIMIT 1)";

}  // namespace

void update_chosen_level(SQLite::Database& database, std::int64_t trial_id,
                         const ChosenLevel& chosen) {
  const int changed =
      execute(database,
              "UPDATE trial SET condition = ?, adaptive_state = ? "
              "WHERE id = ? AND adaptive_state IS NULL",
              to_json(chosen.condition).dump(), to_json(chosen.state).dump(), trial_id);
  if (changed != 1) {
    throw SQLite::Exception("trial " + std::to_string(trial_id) + " has its level already",
                            SQLITE_CONSTRAINT);
  }
}

std::map<std::int64_t, bool> load_counted_answers(SQLite::Database& database,
                                                  std::int64_t enrolment) {
  std::map<std::int64_t, bool> answers;
  for (const auto& [slot, counted] : load_rows<std::int64_t, bool>(
           database,
           std::string("SELECT slot, ") + kCountedAnswerSql +
               " AS counted FROM trial JOIN attempt ON attempt.trial_id = trial.id "
               "WHERE enrolment_id = ? AND track IS NOT NULL "
               "AND outcome = 'completed' AND counted IS NOT NULL",
           enrolment)) {
    answers[slot] = counted;
  }
  return answers;
}

std::vector<StoredAdaptiveTrial> load_adaptive_trials(StudyFile& study) {
  using std::int64_t;
  using std::string;
  return load_as<StoredAdaptiveTrial, int64_t, string, int64_t, int64_t, int64_t, int64_t, string,
                 string, bool, std::optional<bool>>(
      study.database(),
      string("SELECT trial.id, pseudonym, protocol_id, enrolment_id, slot, track, condition, "
             "adaptive_state, attempt.id IS NOT NULL, ") +
          kCountedAnswerSql +
          " FROM trial JOIN enrolment ON enrolment.id = enrolment_id "
          "JOIN participant ON participant.id = participant_id "
          "LEFT JOIN attempt ON attempt.trial_id = trial.id AND outcome = 'completed' "
          "WHERE track IS NOT NULL AND adaptive_state IS NOT NULL ORDER BY enrolment_id, slot");
}

}  // namespace impetus::inline store
