// SPDX-License-Identifier: MIT
#include "experiments/store/screen_rows.hpp"

#include <SQLiteCpp/Statement.h>
#include <SQLiteCpp/VariadicBind.h>

namespace impetus::inline store {

std::optional<ScreenGeometry> last_screen(SQLite::Database& database, std::int64_t enrolment_id) {
  std::optional<ScreenGeometry> last;
  for (const SessionScreen& session : session_screens(database)) {
    if (session.enrolment_id == enrolment_id) {
      last = session.screen;
    }
  }
  return last;
}

std::vector<SessionScreen> session_screens(SQLite::Database& database) {
  SQLite::Statement query(
      database,
      "SELECT session.id, enrolment_id, pseudonym, protocol.name, screen_width_m, "
      "screen_height_m, screen_width_px, screen_height_px, viewing_distance_m, "
      "EXISTS (SELECT 1 FROM note WHERE session_id = session.id AND kind = ?), "
      "EXISTS (SELECT 1 FROM note WHERE session_id = session.id AND kind = ?) "
      "FROM session JOIN enrolment ON enrolment.id = enrolment_id "
      "JOIN participant ON participant.id = participant_id "
      "JOIN protocol ON protocol.id = protocol_id ORDER BY enrolment_id, session.id");
  SQLite::bind(query, kScreenChangedNote, kPixelsNotSquareNote);
  std::vector<SessionScreen> sessions;
  while (query.executeStep()) {
    sessions.push_back(
        {query.getColumn(0).getInt64(),
         query.getColumn(1).getInt64(),
         query.getColumn(2).getString(),
         query.getColumn(3).getString(),
         {query.getColumn(4).getDouble(), query.getColumn(5).getDouble(),
          query.getColumn(6).getInt(), query.getColumn(7).getInt(), query.getColumn(8).getDouble()},
         query.getColumn(9).getInt() != 0,
         query.getColumn(10).getInt() != 0});
  }
  return sessions;
}

}  // namespace impetus::inline store
