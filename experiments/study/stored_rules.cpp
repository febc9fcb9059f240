// SPDX-License-Identifier: MIT
#include "experiments/study/stored_rules.hpp"

#include <SQLiteCpp/Statement.h>

#include <string>
#include <vector>

#include "engine/world/world.hpp"

namespace impetus::inline study {
namespace {

/// Each with `place`, as sentences name it: "P01, causality, slot 5, attempt 1".
constexpr const char* kPlaces =
    "WITH enrolled AS (SELECT enrolment.*, pseudonym || ', ' || name AS place FROM enrolment "
    "  JOIN participant ON participant.id = participant_id "
    "  JOIN protocol ON protocol.id = protocol_id), "
    "planned AS (SELECT trial.*, place || ', slot ' || slot AS place FROM trial "
    "  JOIN enrolled ON enrolled.id = enrolment_id), "
    "shown AS (SELECT attempt.*, slot, phase, enrolment_id, track, adaptive_state, "
    "  place || ', attempt ' || number AS place FROM attempt "
    "  JOIN planned ON planned.id = trial_id), "
    "sitting AS (SELECT session.*, place || ', session ' || session.id AS place FROM session "
    "  JOIN enrolled ON enrolled.id = enrolment_id) ";

constexpr const char* kOrderRules[] = {
    "SELECT 'the study has lost the row that says when and by which build it was made' "
    "WHERE NOT EXISTS (SELECT 1 FROM study)",

    "SELECT place || ': of the planned slots 1 to ' || max(slot) || ' there are ' || "
    "count(trial.id) FROM enrolled LEFT JOIN trial ON enrolment_id = enrolled.id "
    "GROUP BY enrolled.id HAVING count(trial.id) = 0 OR min(slot) <> 1 "
    "OR max(slot) <> count(trial.id)",

    "SELECT planned.place || ': of the attempts 1 to ' || max(number) || ' there are ' || count(*) "
    "FROM planned JOIN attempt ON trial_id = planned.id GROUP BY planned.id "
    "HAVING min(number) <> 1 OR max(number) <> count(*)",

    "SELECT place || ': completed after slot ' || before || ', which the plan has later' FROM "
    "(SELECT place, slot, lag(slot) OVER (PARTITION BY enrolment_id ORDER BY id) AS before "
    "FROM shown WHERE outcome = 'completed') WHERE slot <= before",

    "SELECT place || ': passed over, though slot ' || later || ' was completed' FROM "
    "(SELECT planned.id, place, slot, max(slot) FILTER (WHERE done) OVER "
    "(PARTITION BY enrolment_id, phase) AS later, done FROM (SELECT planned.*, EXISTS (SELECT 1 "
    "FROM attempt WHERE trial_id = planned.id AND outcome = 'completed') AS done FROM planned) "
    "AS planned) WHERE NOT done AND slot < later",

    "SELECT enrolled.place || ': finished, but ' || count(*) || ' of its main trials ' || "
    "iif(count(*) = 1, 'was', 'were') || ' not completed' FROM enrolled JOIN trial "
    "ON enrolment_id = enrolled.id WHERE finished_utc IS NOT NULL AND phase = 'main' AND NOT "
    "EXISTS (SELECT 1 FROM attempt WHERE trial_id = trial.id AND outcome = 'completed') "
    "GROUP BY enrolled.id",

    "SELECT sitting.place || ': ended as finished, but the protocol is not' FROM sitting "
    "JOIN enrolment ON enrolment.id = enrolment_id WHERE ending = 'finished' "
    "AND finished_utc IS NULL",

    "SELECT shown.place || ': belongs to a session of another participant or protocol' FROM shown "
    "JOIN session ON session.id IN (session_id, set_aside_in) "
    "WHERE session.enrolment_id <> shown.enrolment_id",

    "SELECT place || ': completed, but what its adaptive level was chosen by is missing' "
    "FROM shown WHERE outcome = 'completed' AND track IS NOT NULL AND adaptive_state IS NULL",

    "SELECT place || ': follows the gaze of a trial that was not completed' FROM planned "
    "WHERE yoked_trial_id IS NOT NULL AND NOT EXISTS (SELECT 1 FROM attempt "
    "WHERE attempt.trial_id = yoked_trial_id AND outcome = 'completed')",
};

constexpr const char* kRecordingRules[] = {
    "SELECT place || ': completed without a single step' FROM shown WHERE outcome <> 'interrupted' "
    "AND NOT EXISTS (SELECT 1 FROM step WHERE attempt_id = shown.id)",

    "SELECT place || iif(interval = 1, '', ', interval ' || interval) || ': of the steps 0 to ' || "
    "max(step) || ' there are ' || count(*) FROM step JOIN shown ON shown.id = attempt_id "
    "GROUP BY attempt_id, interval HAVING max(step) + 1 <> count(*)",

    "SELECT place || ': ' || timed_frames || ' frames were counted, ' || kept || ' are there' FROM "
    "(SELECT place, timed_frames, (SELECT count(*) FROM frame WHERE attempt_id = shown.id) AS kept "
    "FROM shown) WHERE timed_frames <> kept",

    "SELECT place || ': of the frames 0 to ' || max(frame) || ' there are ' || count(*) FROM frame "
    "JOIN shown ON shown.id = attempt_id GROUP BY attempt_id "
    "HAVING min(frame) <> 0 OR max(frame) + 1 <> count(*)",

    "SELECT place || ': ' || late_timed_frames || ' frames were counted as late, ' || late || "
    "' are' FROM (SELECT place, late_timed_frames, (SELECT count(*) FROM frame "
    "WHERE attempt_id = shown.id AND missed_slots > 0) AS late FROM shown) "
    "WHERE late_timed_frames <> late",

    "SELECT place || ': a collision of ' || body_a || ' and ' || body_b || ' at step ' || "
    "collision.step || ', which is missing' FROM collision JOIN shown ON shown.id = "
    "collision.attempt_id "
    "LEFT JOIN step ON step.attempt_id = collision.attempt_id "
    "AND step.interval = collision.interval AND step.step = collision.step "
    "WHERE step.step IS NULL",

    "SELECT place || ': of the gaze samples 1 to ' || max(sample) || ' there are ' || count(*) "
    "FROM gaze JOIN shown ON shown.id = attempt_id GROUP BY attempt_id "
    "HAVING min(sample) <> 1 OR max(sample) <> count(*)",

    "SELECT place || ': of the clicks 1 to ' || max(click.number) || ' there are ' || count(*) "
    "FROM click JOIN shown ON shown.id = attempt_id GROUP BY attempt_id "
    "HAVING max(click.number) <> count(*)",

    "SELECT place || ': of the answers 1 to ' || max(response.number) || ' there are ' || count(*) "
    "FROM response JOIN shown ON shown.id = attempt_id GROUP BY attempt_id "
    "HAVING max(response.number) <> count(*)",
};

constexpr const char* kProvenanceRules[] = {
    "SELECT place || ': which build recorded it is missing' FROM sitting WHERE trim(build) = ''",
    "SELECT place || ': on which machine is missing' FROM sitting WHERE trim(machine) = ''",
    "SELECT place || ': on which display is missing' FROM sitting WHERE trim(display) = ''",

    "SELECT place || ': recording format ' || recording_format || ', which this build does not "
    "know; use the one that recorded it, ' || build FROM sitting "
    "WHERE recording_format NOT BETWEEN {oldest format} AND {format}",

    "SELECT place || ': trials were recorded though the sync test had failed and was not "
    "overridden' FROM sitting WHERE sync_passed = 0 AND sync_overridden = 0 "
    "AND EXISTS (SELECT 1 FROM attempt WHERE session_id = sitting.id)",

    "SELECT place || ': the sync test''s measurement is missing' FROM sitting "
    "WHERE sync_tries > 0 AND sync_mean_interval_ns IS NULL",

    "SELECT shown.place || ': marked otherwise than its session for an overridden sync test' "
    "FROM shown JOIN session ON session.id = session_id "
    "WHERE shown.sync_overridden <> session.sync_overridden",

    "SELECT place || ': of a simulated participant, but ' || pseudonym || ' is a person' "
    "FROM sitting JOIN enrolment ON enrolment.id = enrolment_id "
    "JOIN participant ON participant.id = participant_id "
    "WHERE sitting.simulated = 1 AND participant.simulated = 0",

    "SELECT place || ': of a person, but ' || pseudonym || ' is simulated' "
    "FROM sitting JOIN enrolment ON enrolment.id = enrolment_id "
    "JOIN participant ON participant.id = participant_id "
    "WHERE sitting.simulated = 0 AND participant.simulated = 1",

    "SELECT place || ': of a person, but it names a simulated observer' FROM sitting "
    "WHERE simulated = 0 AND observer IS NOT NULL",

    "SELECT place || ': has an ending without its time, or the time without it' FROM sitting "
    "WHERE (ending IS NULL) <> (ended_utc IS NULL)",

    "SELECT shown.place || ': its gaze came from another source than its session''s' FROM shown "
    "JOIN session ON session.id = session_id WHERE session.gaze_source IS NOT NULL "
    "AND shown.gaze_source <> session.gaze_source",
};

/// The rule with the numbers that this build puts into it.
std::string with_formats(std::string rule) {
  const std::pair<const char*, int> values[] = {{"{oldest format}", kOldestRecordingFormat},
                                                {"{format}", kRecordingFormat}};
  for (const auto& [name, value] : values) {
    const std::size_t at = rule.find(name);
    if (at != std::string::npos) {
      rule.replace(at, std::string(name).size(), std::to_string(value));
    }
  }
  return rule;
}

template <std::size_t kCount>
Failures broken(SQLite::Database& study, const char* const (&rules)[kCount]) {
  Failures failures;
  for (const char* rule : rules) {
    SQLite::Statement query(study, kPlaces + with_formats(rule));
    while (query.executeStep()) {
      failures.push_back(query.getColumn(0).getString());
    }
  }
  return failures;
}

}  // namespace

Failures broken_order(SQLite::Database& study) { return broken(study, kOrderRules); }

Failures broken_recordings(SQLite::Database& study) { return broken(study, kRecordingRules); }

Failures broken_provenance(SQLite::Database& study) { return broken(study, kProvenanceRules); }

}  // namespace impetus::inline study
