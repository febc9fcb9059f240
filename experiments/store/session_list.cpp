// SPDX-License-Identifier: MIT
#include "experiments/store/session_list.hpp"

#include <SQLiteCpp/Transaction.h>

#include "experiments/store/rows.hpp"

namespace impetus::inline store {
namespace {

/// What is told of every session, and nothing to worry about.
constexpr const char* kOrdinaryNotes =
    "('break', 'demonstration', 'pause', 'continue', 'quit', 'display closed')";

std::vector<NoteSummary> load_notes(SQLite::Database& database, std::int64_t session) {
  // Beside min(id), SQLite takes the other columns from that row.
  return load_as<NoteSummary, std::string, std::int64_t, std::string>(
      database,
      std::string("SELECT kind, count(*), text, min(id) FROM note WHERE session_id = ? "
                  "AND kind NOT IN ") +
          kOrdinaryNotes + " GROUP BY kind ORDER BY min(id)",
      session);
}

std::vector<ListedSession> load_sittings(SQLite::Database& database, std::int64_t enrolment) {
  std::vector<ListedSession> sittings;
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
      "SELECT id, started_utc, ended_utc, last_utc, "
      "(julianday(coalesce(ended_utc, last_utc)) - julianday(started_utc)) * 86400, ending, "
      "resumed_at, resumed_after_s, completed, sync_tries, sync_passed, sync_overridden, "
      "coalesce(gaze_source, attempts_gaze), "
      "(SELECT browser FROM session_provenance WHERE session = id) FROM sitting ORDER BY id");
  query.bind(1, enrolment);
  while (query.executeStep()) {
    NextColumn next(query);
    ListedSession& sitting = sittings.emplace_back();
    next >> sitting.session >> sitting.started_utc >> sitting.ended_utc >>
        sitting.last_recorded_utc >> sitting.length_s >> sitting.ending >> sitting.resumed_at >>
        sitting.resumed_after_s >> sitting.completed_trials >> sitting.sync_tries >>
        sitting.sync_passed >> sitting.sync_overridden >> sitting.gaze_source >> sitting.browser;
    sitting.resumed = sittings.size() > 1;
    sitting.notes = load_notes(database, sitting.session);
  }
  return sittings;
}

std::vector<Participation> load_participations(SQLite::Database& database) {
  SQLite::Statement query(
      database,
      "SELECT enrolment.id, pseudonym, simulated, protocol.name, protocol.hash, "
      "merged_file.name, "
      "(SELECT group_concat((value ->> 'name') || ' ' || (first.condition ->> (value ->> 'name')), "
      "  ', ') FROM json_each(protocol_json, '$.design.factors'), trial AS first "
      "  WHERE first.enrolment_id = enrolment.id AND first.slot = 1 AND value ->> 'between'), "
      "planned_utc, finished_utc, "
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
    NextColumn next(query);
    Participation& one = participations.emplace_back();
    std::int64_t enrolment = 0;
    next >> enrolment >> one.participant >> one.simulated >> one.protocol >> one.protocol_hash >>
        one.merged_from >> one.group >> one.planned_utc >> one.finished_utc >> one.planned_trials >>
        one.completed_trials >> one.practice_trials >> one.interrupted_attempts >>
        one.set_aside_attempts >> one.timed_frames >> one.late_timed_frames;
    one.sittings = load_sittings(database, enrolment);
  }
  return participations;
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
  SessionList list;
  for (const auto& [created_utc, build] :
       load_rows<std::string, std::string>(database, "SELECT created_utc, build FROM study")) {
    list.created_utc = created_utc;
    list.build = build;
  }
  list.participations = load_participations(database);
  list.left_out =
      load_as<LeftOut, std::string, std::optional<std::int64_t>, std::string, std::string>(
          database,
          "SELECT participant, trial, reason, decided_utc FROM excluded ORDER BY decided_utc");
  if (in_use) {
    mark_running(list.participations);
  }
  return list;
}

}  // namespace impetus::inline store
