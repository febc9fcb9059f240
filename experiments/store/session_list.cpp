// SPDX-License-Identifier: MIT
#include "experiments/store/session_list.hpp"

#include <SQLiteCpp/Statement.h>
#include <SQLiteCpp/Transaction.h>

#include <utility>

namespace impetus::inline store {
namespace {

/// What is told of every session, and nothing to worry about.
constexpr const char* kOrdinaryNotes =
    "('break', 'demonstration', 'pause', 'continue', 'quit', 'display closed')";

std::vector<NoteSummary> load_notes(SQLite::Database& database, std::int64_t session) {
  // Beside min(id), SQLite takes the other columns from that row.
  SQLite::Statement query(
      database, std::string("SELECT kind, count(*), text, min(id) FROM note WHERE session_id = ? "
                            "AND kind NOT IN ") +
                    kOrdinaryNotes + " GROUP BY kind ORDER BY min(id)");
  query.bind(1, session);
  std::vector<NoteSummary> notes;
  while (query.executeStep()) {
    notes.push_back({query.getColumn(0).getString(), query.getColumn(1).getInt64(),
                     query.getColumn(2).getString()});
  }
  return notes;
}

std::vector<ListedSession> load_sittings(SQLite::Database& database, std::int64_t enrolment) {
  SQLite::Statement query(
      database,
      "WITH sitting AS (SELECT session.*, "
      "  max(started_utc, coalesce(ended_utc, ''), "
      "    coalesce((SELECT max(saved_utc) FROM attempt WHERE session_id = session.id), ''), "
      "    coalesce((SELECT max(written_utc) FROM note WHERE session_id = session.id), '')) "
      "    AS last_utc, "
      "  (SELECT count(*) FROM attempt WHERE session_id = session.id "
      "    AND outcome <> 'interrupted') AS completed, "
      "  (SELECT min(gaze_source) FROM attempt WHERE session_id = session.id) AS attempts_gaze "
      "  FROM session WHERE enrolment_id = ?) "
      "SELECT id, started_utc, coalesce(ended_utc, ''), last_utc, "
      "(julianday(coalesce(ended_utc, last_utc)) - julianday(started_utc)) * 86400, "
      "coalesce(ending, ''), coalesce(resumed_at, ''), resumed_after_s, completed, sync_passed, "
      "sync_overridden, coalesce(gaze_source, attempts_gaze, ''), sync_tries FROM sitting "
      "ORDER BY id");
  query.bind(1, enrolment);
  std::vector<ListedSession> sittings;
  while (query.executeStep()) {
    ListedSession sitting;
    sitting.session = query.getColumn(0).getInt64();
    sitting.started_utc = query.getColumn(1).getString();
    sitting.ended_utc = query.getColumn(2).getString();
    sitting.last_recorded_utc = query.getColumn(3).getString();
    sitting.length_s = query.getColumn(4).getDouble();
    sitting.ending = query.getColumn(5).getString();
    sitting.resumed = !sittings.empty();
    sitting.resumed_at = query.getColumn(6).getString();
    if (!query.getColumn(7).isNull()) {
      sitting.resumed_after_s = query.getColumn(7).getDouble();
    }
    sitting.completed_trials = query.getColumn(8).getInt64();
    sitting.sync_passed = query.getColumn(9).getInt() != 0;
    sitting.sync_overridden = query.getColumn(10).getInt() != 0;
    sitting.gaze_source = query.getColumn(11).getString();
    sitting.sync_tries = query.getColumn(12).getInt64();
    sitting.notes = load_notes(database, sitting.session);
    sittings.push_back(std::move(sitting));
  }
  return sittings;
}

std::vector<Participation> load_participations(SQLite::Database& database) {
  SQLite::Statement query(
      database,
      "SELECT enrolment.id, pseudonym, simulated, protocol.name, protocol.hash, "
      "coalesce(merged_file.name, ''), planned_utc, coalesce(finished_utc, ''), "
      "count(DISTINCT trial.id) FILTER (WHERE phase = 'main'), "
      "count(*) FILTER (WHERE phase = 'main' AND outcome = 'completed'), "
      "count(*) FILTER (WHERE phase = 'practice' AND outcome = 'completed'), "
      "count(*) FILTER (WHERE outcome = 'interrupted'), "
      "count(*) FILTER (WHERE outcome = 'set aside'), "
      "coalesce(sum(timed_frames), 0), coalesce(sum(late_timed_frames), 0) "
      "FROM enrolment JOIN participant ON participant.id = participant_id "
      "JOIN protocol ON protocol.id = protocol_id "
      "LEFT JOIN merged_file ON merged_file.id = merged_file_id "
      "LEFT JOIN trial ON trial.enrolment_id = enrolment.id "
      "LEFT JOIN attempt ON attempt.trial_id = trial.id "
      "GROUP BY enrolment.id ORDER BY enrolment.id");
  std::vector<Participation> participations;
  while (query.executeStep()) {
    int column = 0;
    const auto integer = [&] { return query.getColumn(column++).getInt64(); };
    const auto text = [&] { return query.getColumn(column++).getString(); };
    Participation one;
    const std::int64_t enrolment = integer();
    one.participant = text();
    one.simulated = integer() != 0;
    one.protocol = text();
    one.protocol_hash = text();
    one.merged_from = text();
    one.planned_utc = text();
    one.finished_utc = text();
    one.planned_trials = integer();
    one.completed_trials = integer();
    one.practice_trials = integer();
    one.interrupted_attempts = integer();
    one.set_aside_attempts = integer();
    one.timed_frames = integer();
    one.late_timed_frames = integer();
    one.sittings = load_sittings(database, enrolment);
    participations.push_back(std::move(one));
  }
  return participations;
}

std::vector<LeftOut> load_left_out(SQLite::Database& database) {
  SQLite::Statement query(database,
                          "SELECT participant, trial, reason, decided_utc FROM excluded "
                          "ORDER BY decided_utc");
  std::vector<LeftOut> left_out;
  while (query.executeStep()) {
    LeftOut one;
    one.participant = query.getColumn(0).getString();
    if (!query.getColumn(1).isNull()) {
      one.trial = query.getColumn(1).getInt64();
    }
    one.reason = query.getColumn(2).getString();
    one.decided_utc = query.getColumn(3).getString();
    left_out.push_back(std::move(one));
  }
  return left_out;
}

/// Of an enrolment's sessions only the last can be running.
void mark_running(std::vector<Participation>& participations) {
  for (Participation& one : participations) {
    if (!one.sittings.empty() && one.sittings.back().ending.empty()) {
      one.sittings.back().running = true;
    }
  }
}

}  // namespace

SessionList load_session_list(StudyFile& study, bool in_use) {
  SQLite::Database& database = study.database();
  SQLite::Transaction one_moment(database);
  SQLite::Statement made(database, "SELECT created_utc, build FROM study");
  SessionList list;
  if (made.executeStep()) {
    list.created_utc = made.getColumn(0).getString();
    list.build = made.getColumn(1).getString();
  }
  list.participations = load_participations(database);
  list.left_out = load_left_out(database);
  if (in_use) {
    mark_running(list.participations);
  }
  return list;
}

}  // namespace impetus::inline store
