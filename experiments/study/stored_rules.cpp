// SPDX-License-Identifier: MIT
#include "experiments/study/stored_rules.hpp"

#include <SQLiteCpp/Statement.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "engine/world/world.hpp"
#include "experiments/record/lab_screen.hpp"
#include "experiments/store/session_rows.hpp"

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

/// Each yields one sentence, or no row where there is nothing to say.
constexpr const char* kRemarks[] = {
    "SELECT 'nothing is recorded in it yet' WHERE NOT EXISTS (SELECT 1 FROM attempt)",

    "SELECT count(*) || ' of ' || (SELECT count(*) FROM participant) || ' participants ' || "
    "iif(count(*) = 1, 'is', 'are') || ' simulated' FROM participant WHERE simulated "
    "HAVING count(*) > 0",

    "SELECT count(*) || ' of ' || (SELECT count(*) FROM enrolment) || ' enrolments ' || "
    "iif(count(*) = 1, 'is', 'are') || ' not finished' FROM enrolment WHERE finished_utc IS NULL "
    "HAVING count(*) > 0",

    "SELECT count(*) || ' of ' || (SELECT count(*) FROM session) || ' sessions ' || "
    "iif(count(*) = 1, 'has', 'have') || ' no ending: killed, or running now' FROM session "
    "WHERE ending IS NULL HAVING count(*) > 0",

    "SELECT 'it was anonymised, by ' || anonymised_by FROM study WHERE anonymised_by IS NOT NULL",

    "SELECT count(DISTINCT enrolment_id) || ' people''s enrolments have trials, but no consent "
    "that was kept' FROM session WHERE simulated = 0 "
    "AND (SELECT anonymised_by FROM study) IS NULL "
    "AND EXISTS (SELECT 1 FROM attempt WHERE session_id = session.id) "
    "AND NOT EXISTS (SELECT 1 FROM answer JOIN session AS other ON other.id = answer.session_id "
    "WHERE other.enrolment_id = session.enrolment_id AND kind = 'consent' AND answer = 'agreed') "
    "HAVING count(*) > 0",

    "SELECT count(*) || ' trials were shown by a display that had failed its sync test (marked "
    "sync_overridden)' FROM attempt WHERE sync_overridden AND outcome = 'completed' "
    "HAVING count(*) > 0",

    "SELECT sum(late_timed_frames) || ' of ' || sum(timed_frames) || ' timed frames were late (' "
    "|| "
    "printf('%.2g', 100.0 * sum(late_timed_frames) / sum(timed_frames)) || ' %)' FROM attempt "
    "HAVING sum(late_timed_frames) > 0",

    "SELECT count(*) || ' trials showed gaze-dependent detail too late (marked gaze_late)' "
    "FROM attempt WHERE gaze_late AND outcome = 'completed' HAVING count(*) > 0",

    "SELECT count(*) || ' trials held their contact otherwise than intended, rounded to the "
    "display''s frames' FROM attempt WHERE outcome = 'completed' "
    "AND abs(realised_hold_ms - intended_hold_ms) > 1e-6 HAVING count(*) > 0",

    "SELECT count(*) || ' sessions of people before a screen whose size was assumed, not entered' "
    "FROM session WHERE simulated = 0 AND screen_measured = 0 HAVING count(*) > 0",

    "SELECT count(*) || ' attempts were interrupted and shown again' FROM attempt "
    "WHERE outcome = 'interrupted' HAVING count(*) > 0",

    "SELECT count(*) || ' completed attempts were set aside: resumed sessions began their blocks "
    "anew' FROM attempt WHERE outcome = 'set aside' HAVING count(*) > 0",

    "SELECT count(*) || ' notes say that the state of a body was no longer finite' FROM note "
    "WHERE kind = 'not finite' HAVING count(*) > 0",

    "SELECT 'left out of the analysis: ' || (SELECT count(*) FROM excluded WHERE trial IS NULL) || "
    "' participants, ' || (SELECT count(*) FROM excluded WHERE trial IS NOT NULL) || "
    "' single trials, with reasons' WHERE EXISTS (SELECT 1 FROM excluded)",

    "SELECT 'it holds ' || count(*) || ' versions of ' || name FROM protocol GROUP BY name "
    "HAVING count(*) > 1",

    "SELECT 'it was merged from ' || count(*) || ' files of stations' FROM merged_file "
    "HAVING count(*) > 0",

    "SELECT count(*) || ' sessions were recorded by a build with changes that no commit holds "
    "(-dirty)' FROM session WHERE build LIKE '%-dirty%' HAVING count(*) > 0",

    "SELECT count(*) || ' sessions were recorded by a build whose commit is not known' "
    "FROM session WHERE build LIKE '%unknown commit%' HAVING count(*) > 0",

    "SELECT 'participants'' own words are in it: ' || count(*) || ' answers about themselves or in "
    "free text; impetus export --anonymise leaves them out' FROM (SELECT answer FROM answer "
    "WHERE kind IN ('demographic', 'question') AND answer IS NOT NULL UNION ALL "
    "SELECT answer FROM response WHERE kind = 'free_text' AND answer IS NOT NULL) "
    "HAVING count(*) > 0",
};

/// "P01, causality, session 2: ".
std::string place_of(const SessionScreen& session) {
  return session.participant + ", " + session.protocol + ", session " +
         std::to_string(session.session_id) + ": ";
}

}  // namespace

Failures broken_order(SQLite::Database& study) { return broken(study, kOrderRules); }

Failures broken_recordings(SQLite::Database& study) { return broken(study, kRecordingRules); }

Failures broken_provenance(SQLite::Database& study) { return broken(study, kProvenanceRules); }

std::vector<std::string> remarks_on(SQLite::Database& study) {
  std::vector<std::string> remarks;
  for (const char* remark : kRemarks) {
    SQLite::Statement query(study, remark);
    while (query.executeStep()) {
      remarks.push_back(query.getColumn(0).getString());
    }
  }
  return remarks;
}

Failures unsaid_screens(SQLite::Database& study) {
  Failures failures;
  const SessionScreen* before = nullptr;
  const std::vector<SessionScreen> sessions = session_screens(study);
  for (const SessionScreen& session : sessions) {
    if (!has_square_pixels(session.screen) && !session.said_not_square) {
      failures.push_back(place_of(session) + "each pixel was " + pixel_words(session.screen) +
                         " (" + screen_words(session.screen) +
                         "), and nobody said that they are not square");
    }
    const bool resumed = before != nullptr && before->enrolment_id == session.enrolment_id;
    if (resumed && !is_same_screen(before->screen, session.screen) && !session.said_changed) {
      failures.push_back(place_of(session) + "sat before " + screen_words(session.screen) +
                         ", in the session before " + screen_words(before->screen) +
                         ", and nobody said that the screen changed");
    }
    before = &session;
  }
  return failures;
}

std::vector<std::string> screen_remarks(SQLite::Database& study) {
  std::int64_t not_square = 0;
  std::map<std::string, std::vector<ScreenGeometry>> screens;  // of each participant
  for (const SessionScreen& session : session_screens(study)) {
    not_square += session.said_not_square ? 1 : 0;
    std::vector<ScreenGeometry>& known = screens[session.participant];
    if (std::none_of(known.begin(), known.end(), [&](const ScreenGeometry& screen) {
          return is_same_screen(screen, session.screen);
        })) {
      known.push_back(session.screen);
    }
  }
  std::vector<std::string> remarks;
  for (const auto& [participant, seen] : screens) {
    if (seen.size() > 1) {
      std::string words = participant + " sat before " + std::to_string(seen.size()) + " screens: ";
      for (const ScreenGeometry& screen : seen) {
        words += (&screen == &seen.front() ? "" : "; ") + screen_words(screen);
      }
      remarks.push_back(words);
    }
  }
  if (not_square > 0) {
    remarks.push_back(std::to_string(not_square) +
                      " sessions were before a screen whose pixels, as was said, are not square");
  }
  return remarks;
}

}  // namespace impetus::inline study
