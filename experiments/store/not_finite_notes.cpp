// SPDX-License-Identifier: MIT
#include "experiments/store/not_finite_notes.hpp"

#include <SQLiteCpp/Statement.h>

#include <algorithm>
#include <string>

namespace impetus::inline store {
namespace {

std::string text_of(const AttemptRecord& attempt, const StepRecord& step,
                    const NotFiniteBody& found) {
  return "trial " + std::to_string(attempt.slot) + ", attempt " + std::to_string(attempt.number) +
         ", step " + std::to_string(step.step) + ": " +
         attempt.body_names.at(static_cast<std::size_t>(found.body)) + ", " +
         std::string(name_of(found.field));
}

}  // namespace

bool has_not_finite(const AttemptRecord& attempt) {
  return std::any_of(attempt.steps.begin(), attempt.steps.end(),
                     [](const StepRecord& step) { return !step.not_finite.empty(); });
}

void insert_not_finite_notes(SQLite::Database& database, std::int64_t session_id,
                             const AttemptRecord& attempt) {
  for (const StepRecord& step : attempt.steps) {
    for (const NotFiniteBody& found : step.not_finite) {
      SQLite::Statement insert(database,
                               "INSERT INTO note (session_id, written_utc, kind, text) "
                               "VALUES (?, strftime('%Y-%m-%dT%H:%M:%fZ'), 'not finite', ?)");
      insert.bind(1, session_id);
      insert.bind(2, text_of(attempt, step, found));
      insert.exec();
    }
  }
}

}  // namespace impetus::inline store
