// SPDX-License-Identifier: MIT
#include "experiments/store/resumption_rows.hpp"

#include <SQLiteCpp/Statement.h>
#include <SQLiteCpp/VariadicBind.h>

namespace impetus::inline store {

std::optional<double> seconds_since_recorded(SQLite::Database& database,
                                             std::int64_t enrolment_id) {
  SQLite::Statement query(
      database,
      "WITH sitting AS (SELECT * FROM session WHERE enrolment_id = ?), "
      "recorded (at_utc) AS ("
      "SELECT started_utc FROM sitting UNION ALL SELECT ended_utc FROM sitting UNION ALL "
      "SELECT written_utc FROM note WHERE session_id IN (SELECT id FROM sitting) UNION ALL "
      "SELECT saved_utc FROM attempt WHERE session_id IN (SELECT id FROM sitting)) "
      "SELECT (julianday('now') - julianday(max(at_utc))) * 86400 FROM recorded");
  query.bind(1, enrolment_id);
  query.executeStep();
  const SQLite::Column seconds = query.getColumn(0);
  return seconds.isNull() ? std::nullopt : std::optional(seconds.getDouble());
}

void set_aside(SQLite::Database& database, std::int64_t enrolment_id, std::int64_t session_id,
               const std::set<std::int64_t>& slots) {
  SQLite::Statement update(database,
                           "UPDATE attempt SET outcome = 'set aside', set_aside_in = ? "
                           "WHERE outcome = 'completed' AND trial_id = "
                           "(SELECT id FROM trial WHERE enrolment_id = ? AND slot = ?)");
  for (const std::int64_t slot : slots) {
    SQLite::bind(update, session_id, enrolment_id, slot);
    update.exec();
    update.reset();
  }
}

}  // namespace impetus::inline store
