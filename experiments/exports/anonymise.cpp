// SPDX-License-Identifier: MIT
#include "experiments/exports/anonymise.hpp"

#include <SQLiteCpp/Transaction.h>

#include <nlohmann/json.hpp>
#include <vector>

#include "experiments/exports/row_query.hpp"
#include "experiments/questions/response_kinds.hpp"
#include "experiments/store/rows.hpp"
#include "experiments/store/schema_words.hpp"

namespace impetus::inline exports {
namespace {

using nlohmann::json;

/// Tables whose rows are numbered, those that others refer to first, and the new order of each.
struct Renumbered {
  const char* table;
  const char* order;
};

constexpr Renumbered kRenumbered[] = {
    {"participant", "random()"},       {"enrolment", "participant_id, id"},
    {"session", "enrolment_id, id"},   {"trial", "enrolment_id, slot"},
    {"attempt", "session_id, id"},     {"collision", "attempt_id, id"},
    {"calibration", "session_id, id"}, {"answer", "session_id, id"},
    {"note", "session_id, id"},        {"exclusion", "participant_id, id"}};

/// Gives the rows of a table new numbers, also where others refer to them. Numbers are negative on
/// the way, so that a new one never meets an old one.
void renumber(SQLite::Database& study, const Renumbered& each) {
  const std::string table = each.table;
  study.exec("CREATE TEMP TABLE renumbering AS SELECT id AS old, row_number() OVER (ORDER BY " +
             std::string(each.order) + ") AS new FROM " + table);
  study.exec("CREATE UNIQUE INDEX temp.renumbering_old ON renumbering (old)");
  const auto apply = [&](const std::string& changed, const std::string& column) {
    study.exec("UPDATE " + changed + " SET " + column + " = -(SELECT new FROM renumbering WHERE " +
               "old = " + column + ") WHERE " + column + " IS NOT NULL");
    study.exec("UPDATE " + changed + " SET " + column + " = -" + column + " WHERE " + column +
               " < 0");
  };
  apply(table, "id");
  for (const auto& [other, columns] : schema_words()) {
    for (const auto& [column, words] : columns) {
      if (words.refers_to == table) {
        apply(other, column);
      }
    }
  }
  study.exec("DROP TABLE temp.renumbering");
}

/// The new codes: A, and a number of as many digits as there are participants to tell apart. Called
/// once participants are in their new order.
void give_new_codes(SQLite::Database& study) {
  study.exec("UPDATE participant SET pseudonym = '\x01' || id");  // none of the old ones
  study.exec(
      "UPDATE participant SET pseudonym = 'A' || printf('%0*d', max(2, length((SELECT count(*) "
      "FROM participant))), id)");
}

/// A protocol may name the participant whose gaze it borrows.
void rename_in_protocols(SQLite::Database& study, const std::map<std::string, std::string>& codes,
                         const ProtocolHash& hash) {
  /// A protocol that names participants anew, and its new hash.
  struct Changed {
    std::int64_t id;
    std::string protocol;
    std::string hash;
  };
  std::map<std::string, std::string> strangers;
  const auto stranger =
      [&](const std::string& code) {  // who is not in the study; each has one name
        const std::string number =
            strangers.empty() ? "" : "-" + std::to_string(strangers.size() + 1);
        return strangers.try_emplace(code, "A00" + number).first->second;
      };
  std::vector<Changed> changed;
  RowQuery query(study, "SELECT id, protocol_json, scene_json FROM protocol");
  const json::json_pointer place("/gaze/yoked_to/participant");
  while (query.step()) {
    json protocol = json::parse(query.bytes(1), nullptr, false);
    if (protocol.is_discarded() || !protocol.contains(place) || !protocol.at(place).is_string() ||
        protocol.at(place) == YokeRule::kPrevious ||
        protocol.at(place) == YokeRule::kLeastFollowed) {
      continue;
    }
    const auto was = protocol.at(place).get<std::string>();
    const auto code = codes.find(was);
    protocol[place] = code == codes.end() ? stranger(was) : code->second;
    const std::string text = protocol.dump(2);
    changed.push_back({query.integer(0), text, hash(text, query.text(2))});
  }
  for (const Changed& each : changed) {
    execute(study, "UPDATE protocol SET protocol_json = ?, hash = ? WHERE id = ?", each.protocol,
            each.hash, each.id);
  }
}

std::map<std::int64_t, std::string> codes_by_name_of_row(SQLite::Database& study) {
  std::map<std::int64_t, std::string> codes;
  RowQuery query(study, "SELECT id, pseudonym FROM participant");
  while (query.step()) {
    codes[query.integer(0)] = query.text(1);
  }
  return codes;
}

/// From the old codes to the new ones. `old_code` stands in the study while rows move.
std::map<std::string, std::string> renumber_people(SQLite::Database& study) {
  std::map<std::string, std::string> codes;
  for (const Renumbered& each : kRenumbered) {
    renumber(study, each);
  }
  const auto old = codes_by_name_of_row(study);
  give_new_codes(study);
  for (const auto& [id, code] : codes_by_name_of_row(study)) {
    codes[old.at(id)] = code;
  }
  return codes;
}

void take_out_what_was_typed(SQLite::Database& study) {
  for (const ResponseKind& kind : response_kinds()) {
    if (kind.is_typed) {
      study.exec("UPDATE response SET answer = NULL, detail = '{}' WHERE kind = '" + kind.name +
                 "'");
    }
  }
  study.exec(
      "UPDATE answer SET answer = NULL; "
      "UPDATE note SET text = ''; "
      "UPDATE exclusion SET reason = 'not told'; "
      "UPDATE session SET machine = 'not told'; "
      "UPDATE session SET page_name = 'not told', page_key = NULL WHERE page_name IS NOT NULL; "
      "UPDATE participant SET merged_file_id = NULL; DELETE FROM merged_file;");
}

/// Days since the participant's own first, so that no date tells who came before whom.
void shift_days(SQLite::Database& study) {
  study.exec(
      "CREATE TEMP TABLE first_day AS SELECT enrolment.id AS enrolment_id, participant_id, "
      "(SELECT min(other.planned_utc) FROM enrolment AS other WHERE other.participant_id = "
      "enrolment.participant_id) AS day FROM enrolment");
  const auto shift = [&](const std::string& table, const std::string& column,
                         const std::string& first) {
    study.exec("UPDATE " + table + " SET " + column +
               " = strftime('%Y-%m-%dT00:00:00Z', '2000-01-01', coalesce(julianday(substr(" +
               column + ", 1, 10)) - julianday(substr((" + first +
               "), 1, 10)), 0) || ' days') WHERE " + column + " IS NOT NULL");
  };
  const std::string of_enrolment = "SELECT day FROM first_day WHERE enrolment_id = ";
  const std::string of_session =
      of_enrolment + "(SELECT enrolment_id FROM session AS own WHERE own.id = ";
  shift("attempt", "saved_utc", of_session + "attempt.session_id)");
  shift("note", "written_utc", of_session + "note.session_id)");
  shift("exclusion", "decided_utc",
        "SELECT min(day) FROM first_day WHERE participant_id = exclusion.participant_id");
  shift("session", "started_utc", of_enrolment + "session.enrolment_id");
  shift("session", "ended_utc", of_enrolment + "session.enrolment_id");
  shift("enrolment", "finished_utc", of_enrolment + "enrolment.id");
  shift("enrolment", "planned_utc", of_enrolment + "enrolment.id");
  study.exec("UPDATE study SET created_utc = '2000-01-01T00:00:00Z'; DROP TABLE temp.first_day");
}

/// Whether a column is an instant of the clock of frames, no length of time.
bool is_instant(const std::string& column) {
  return column.ends_with("_ns") && !column.ends_with("uncertainty_ns") &&
         !column.ends_with("age_ns") && !column.ends_with("interval_ns");
}

/// A clock that runs since the machine was switched on would tell who came before whom.
void shift_clocks(SQLite::Database& study) {
  study.exec(
      "CREATE TEMP TABLE clock AS SELECT session.id AS session_id, min("
      "coalesce((SELECT min(onset_ns) FROM attempt WHERE session_id = session.id AND onset_ns > 0),"
      " 9000000000000000000), coalesce((SELECT min(flipped_ns) FROM frame JOIN attempt ON "
      "attempt.id = attempt_id "
      "WHERE session_id = session.id), 9000000000000000000), coalesce((SELECT min(began_ns) FROM "
      "calibration "
      "WHERE session_id = session.id), 9000000000000000000)) - 1000000000 AS zero_ns FROM session; "
      "CREATE UNIQUE INDEX temp.clock_session ON clock (session_id)");
  for (const auto& [table, columns] : schema_words()) {
    const bool of_session = columns.count("session_id") > 0;
    if (!of_session && columns.count("attempt_id") == 0) {
      continue;
    }
    const std::string session =
        of_session
            ? table + ".session_id"
            : "(SELECT own.session_id FROM attempt AS own WHERE own.id = " + table + ".attempt_id)";
    for (const auto& [column, words] : columns) {
      if (is_instant(column)) {
        study.exec("UPDATE " + table + " SET " + column + " = " + column +
                   " - (SELECT zero_ns FROM clock WHERE clock.session_id = " + session +
                   ") WHERE " + column + " > 0");
      }
    }
  }
  study.exec("DROP TABLE temp.clock");
}

}  // namespace

void anonymise(SQLite::Database& study, const std::string& build, const ProtocolHash& hash) {
  study.exec("PRAGMA foreign_keys = OFF");  // rows change their numbers one table after another
  SQLite::Transaction transaction(study);
  rename_in_protocols(study, renumber_people(study), hash);
  take_out_what_was_typed(study);
  shift_days(study);
  shift_clocks(study);
  execute(study, "UPDATE study SET anonymised_by = ?", build);
  transaction.commit();
}

}  // namespace impetus::inline exports
