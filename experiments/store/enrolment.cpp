// SPDX-License-Identifier: MIT
#include "experiments/store/enrolment.hpp"

#include <SQLiteCpp/Transaction.h>

#include <utility>

#include "experiments/settings/input_error.hpp"
#include "experiments/store/adaptive_rows.hpp"
#include "experiments/store/rows.hpp"

namespace impetus::inline store {
namespace {

using std::int64_t;
using std::optional;
using std::string;

constexpr const char* kParticipantSql = "SELECT id FROM participant WHERE pseudonym = ?";

void require_kind(StudyFile& study, const string& pseudonym, bool simulated) {
  const auto is_simulated = load_value<bool>(
      study.database(), "SELECT simulated FROM participant WHERE pseudonym = ?", pseudonym);
  if (is_simulated && *is_simulated != simulated) {
    throw InputError(study.name() + ": participant " + pseudonym + " is " +
                     (*is_simulated ? "simulated" : "a person") + " in this study; " +
                     (simulated ? "a simulated one" : "a person") + " needs another name");
  }
}

void load_attempts(SQLite::Database& database, int64_t enrolment, SessionHistory& history) {
  for (const auto& [slot, attempts, completed] : load_rows<int64_t, int64_t, bool>(
           database,
           "SELECT slot, max(number), max(outcome = 'completed') FROM trial "
           "JOIN attempt ON attempt.trial_id = trial.id WHERE enrolment_id = ? GROUP BY slot",
           enrolment)) {
    history.attempts[slot] = attempts;
    if (completed) {
      history.completed_slots.insert(slot);
    }
  }
}

void load_practice(SQLite::Database& database, int64_t enrolment, SessionHistory& history) {
  for (const auto& [slot, rating, clicks, right] :
       load_rows<int64_t, optional<int64_t>, int64_t, optional<bool>>(
           database,
           "SELECT slot, rating, (SELECT count(*) FROM click WHERE click.attempt_id = attempt.id), "
           "(SELECT min(correct) FROM response WHERE response.attempt_id = attempt.id) FROM trial "
           "JOIN attempt ON attempt.trial_id = trial.id "
           "LEFT JOIN rating ON rating.attempt_id = attempt.id "
           "WHERE enrolment_id = ? AND phase = 'practice' AND outcome = 'completed'",
           enrolment)) {
    PracticeResult& result = history.practice[slot];
    result.rating = rating ? rating : result.rating;
    result.clicks = clicks;
    result.right = right ? right : result.right;
  }
}

SessionHistory load_history(SQLite::Database& database, int64_t enrolment) {
  SessionHistory history;
  history.resumed =
      load_value<int64_t>(database, "SELECT id FROM session WHERE enrolment_id = ?", enrolment)
          .has_value();
  load_attempts(database, enrolment, history);
  load_practice(database, enrolment, history);
  history.counted_answers = load_counted_answers(database, enrolment);
  for (const string& question :
       load_column<string>(database,
                           "SELECT DISTINCT question FROM answer JOIN session "
                           "ON session.id = session_id WHERE enrolment_id = ? "
                           "AND NOT (kind = 'consent' AND answer = 'declined')",
                           enrolment)) {
    history.answered.insert(question);
  }
  return history;
}

int64_t find_or_insert_participant(SQLite::Database& database, const string& pseudonym,
                                   bool simulated) {
  const auto known = load_value<int64_t>(database, kParticipantSql, pseudonym);
  return known ? *known
               : insert_row(database, "participant",
                            {{"pseudonym", pseudonym}, {"simulated", simulated}});
}

int64_t find_or_insert_protocol(SQLite::Database& database, const ProtocolTexts& protocol) {
  const auto known =
      load_value<int64_t>(database, "SELECT id FROM protocol WHERE hash = ?", protocol.hash);
  return known ? *known
               : insert_row(database, "protocol",
                            {{"name", protocol.name},
                             {"hash", protocol.hash},
                             {"protocol_json", protocol.protocol_json},
                             {"scene_json", protocol.scene_json}});
}

int64_t insert_trial(SQLite::Database& database, int64_t enrolment, const StoredTrial& trial) {
  return insert_row(database, "trial",
                    {{"enrolment_id", enrolment},
                     {"slot", trial.slot},
                     {"phase", std::string(name_of(trial.phase))},
                     {"repetition", trial.repetition},
                     {"condition", trial.condition},
                     {"seed", trial.seed},
                     {"block", trial.block},
                     {"catch", trial.catch_trial},
                     {"track", trial.track},
                     {"solved", text_or_null(trial.solved)},
                     {"yoked_trial_id", trial.yoked_trial_id}});
}

}  // namespace

std::vector<StoredTrial> load_trials(SQLite::Database& database, int64_t enrolment_id) {
  std::vector<StoredTrial> trials;
  for (const auto& [id, slot, phase, repetition, condition, seed, block, catch_trial, track, state,
                    solved, yoked] :
       load_rows<int64_t, int64_t, string, int64_t, string, std::uint64_t, int64_t, bool,
                 optional<int64_t>, string, string, optional<int64_t>>(
           database,
           "SELECT id, slot, phase, repetition, condition, seed, block, catch, track, "
           "adaptive_state, solved, yoked_trial_id "
           "FROM trial WHERE enrolment_id = ? ORDER BY slot",
           enrolment_id)) {
    trials.push_back({id, slot, phase_named(phase), repetition, condition, seed, block, catch_trial,
                      track, state, solved, yoked});
  }
  return trials;
}

Enrolment load_enrolment(StudyFile& study, int64_t id) {
  const auto seed =
      load_value<std::uint64_t>(study.database(), "SELECT seed FROM enrolment WHERE id = ?", id);
  return {id, seed.value(), load_trials(study.database(), id), load_history(study.database(), id)};
}

std::optional<Enrolment> find_enrolment(StudyFile& study, const string& pseudonym, bool simulated,
                                        const ProtocolTexts& protocol) {
  require_kind(study, pseudonym, simulated);
  const auto found = load_rows<int64_t, string, string>(
      study.database(),
      "SELECT enrolment.id, finished_utc, hash "
      "FROM enrolment JOIN participant ON participant.id = participant_id "
      "JOIN protocol ON protocol.id = protocol_id WHERE pseudonym = ? AND name = ?",
      pseudonym, protocol.name);
  if (found.empty()) {
    return std::nullopt;
  }
  const auto& [id, finished_utc, hash] = found.front();
  if (!finished_utc.empty()) {
    throw InputError(study.name() + ": participant " + pseudonym + " has finished " +
                     protocol.name + " already, at " + finished_utc);
  }
  if (hash != protocol.hash) {
    throw InputError(study.name() + ": participant " + pseudonym +
                     " began with another version of " + protocol.name +
                     "; resume with the file it was, or use another name");
  }
  return load_enrolment(study, id);
}

bool has_finished(StudyFile& study, const string& pseudonym, bool simulated,
                  const ProtocolTexts& protocol) {
  const auto finished =
      load_value<int64_t>(study.database(),
                          "SELECT count(*) FROM enrolment "
                          "JOIN participant ON participant.id = participant_id "
                          "JOIN protocol ON protocol.id = protocol_id WHERE pseudonym = ? "
                          "AND simulated = ? AND hash = ? AND finished_utc IS NOT NULL",
                          pseudonym, simulated ? 1 : 0, protocol.hash);
  return *finished > 0;
}

Enrolment insert_enrolment(SQLite::Database& database, NewEnrolment fresh) {
  const int64_t participant =
      find_or_insert_participant(database, fresh.pseudonym, fresh.simulated);
  const int64_t version = find_or_insert_protocol(database, fresh.protocol);
  Enrolment enrolment;
  enrolment.seed = fresh.seed;
  enrolment.id = insert_row(database, "enrolment",
                            {{"participant_id", participant},
                             {"protocol_id", version},
                             {"seed", fresh.seed},
                             {"planned_utc", Now()}});
  for (StoredTrial& trial : fresh.trials) {
    trial.id = insert_trial(database, enrolment.id, trial);
  }
  enrolment.trials = std::move(fresh.trials);
  return enrolment;
}

Enrolment enrol(StudyFile& study, const string& pseudonym, bool simulated,
                const ProtocolTexts& protocol, std::uint64_t seed,
                std::vector<StoredTrial> trials) {
  try {
    SQLite::Transaction transaction(study.database());
    Enrolment enrolment = insert_enrolment(
        study.database(), {pseudonym, simulated, protocol, seed, std::move(trials)});
    transaction.commit();
    return enrolment;
  } catch (const SQLite::Exception& error) {
    throw StoreError(study.name() + ": the plan could not be saved: " + error.what());
  }
}

std::vector<string> first_conditions(StudyFile& study, const string& protocol, bool simulated) {
  return load_column<string>(
      study.database(),
      "SELECT condition FROM trial JOIN enrolment ON enrolment.id = enrolment_id "
      "JOIN participant ON participant.id = participant_id "
      "JOIN protocol ON protocol.id = protocol_id "
      "WHERE slot = 1 AND protocol.name = ? AND simulated = ? "
      "AND NOT EXISTS (SELECT 1 FROM excluded WHERE participant = pseudonym AND trial IS NULL) "
      "AND NOT EXISTS (SELECT 1 FROM session WHERE enrolment_id = enrolment.id "
      "AND ending = 'declined' AND id = (SELECT max(id) FROM session AS last "
      "WHERE last.enrolment_id = enrolment.id)) ORDER BY enrolment.id",
      protocol, simulated ? 1 : 0);
}

std::map<string, string> told_demographics(StudyFile& study, const string& pseudonym) {
  std::map<string, string> told;
  for (auto& [question, words] :
       load_rows<string, string>(study.database(),
                                 "SELECT question, words FROM questionnaire "
                                 "WHERE participant = ? AND kind = 'demographic'",
                                 pseudonym)) {
    told[question] = words;
  }
  return told;
}

std::vector<string> other_versions(StudyFile& study, const ProtocolTexts& protocol) {
  return load_column<string>(study.database(),
                             "SELECT hash FROM protocol WHERE name = ? AND hash <> ?",
                             protocol.name, protocol.hash);
}

}  // namespace impetus::inline store
