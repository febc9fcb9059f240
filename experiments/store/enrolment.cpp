// SPDX-License-Identifier: MIT
#include "experiments/store/enrolment.hpp"

#include <SQLiteCpp/Statement.h>
#include <SQLiteCpp/Transaction.h>
#include <SQLiteCpp/VariadicBind.h>

#include <utility>

#include "experiments/settings/input_error.hpp"
#include "experiments/store/adaptive_rows.hpp"
#include "experiments/store/yoke_rows.hpp"

namespace impetus::inline store {
namespace {

constexpr const char* phase_name(TrialPhase phase) {
  return phase == TrialPhase::kPractice ? "practice" : "main";
}

/// Runs an INSERT and returns the new row's id.
template <typename... Values>
std::int64_t insert(SQLite::Database& database, const char* sql, const Values&... values) {
  SQLite::Statement statement(database, sql);
  SQLite::bind(statement, values...);
  statement.exec();
  return database.getLastInsertRowid();
}

/// The first column of the first row, if any.
template <typename... Values>
std::optional<std::int64_t> find_id(SQLite::Database& database, const char* sql,
                                    const Values&... values) {
  SQLite::Statement statement(database, sql);
  SQLite::bind(statement, values...);
  if (!statement.executeStep()) {
    return std::nullopt;
  }
  return statement.getColumn(0).getInt64();
}

void require_kind(StudyFile& study, const std::string& pseudonym, bool simulated) {
  const auto kind =
      find_id(study.database(), "SELECT simulated FROM participant WHERE pseudonym = ?", pseudonym);
  if (kind && (*kind != 0) != simulated) {
    throw InputError(study.name() + ": participant " + pseudonym + " is " +
                     (*kind != 0 ? "simulated" : "a person") + " in this study; " +
                     (simulated ? "a simulated one" : "a person") + " needs another name");
  }
}

std::optional<std::int64_t> number_or_none(SQLite::Statement& query, int column) {
  const SQLite::Column value = query.getColumn(column);
  return value.isNull() ? std::nullopt : std::optional(value.getInt64());
}

void take_yokes(SQLite::Database& database, std::int64_t enrolment,
                std::vector<StoredTrial>& trials) {
  const Yokes yokes = load_yokes(database, enrolment);
  for (StoredTrial& trial : trials) {
    const auto found = yokes.find(trial.slot);
    if (found != yokes.end()) {
      trial.yoked_trial_id = found->second;
    }
  }
}

Yokes yokes_of(const std::vector<StoredTrial>& trials) {
  Yokes yokes;
  for (const StoredTrial& trial : trials) {
    if (trial.yoked_trial_id) {
      yokes[trial.slot] = *trial.yoked_trial_id;
    }
  }
  return yokes;
}

SessionHistory load_history(SQLite::Database& database, std::int64_t enrolment) {
  SessionHistory history;
  history.resumed =
      find_id(database, "SELECT id FROM session WHERE enrolment_id = ?", enrolment).has_value();
  SQLite::Statement attempts(database,
                             "SELECT slot, max(number), max(outcome = 'completed') FROM trial "
                             "JOIN attempt ON attempt.trial_id = trial.id "
                             "WHERE enrolment_id = ? GROUP BY slot");
  attempts.bind(1, enrolment);
  while (attempts.executeStep()) {
    const std::int64_t slot = attempts.getColumn(0).getInt64();
    history.attempts[slot] = attempts.getColumn(1).getInt64();
    if (attempts.getColumn(2).getInt() != 0) {
      history.completed_slots.insert(slot);
    }
  }
  SQLite::Statement practice(database,
                             "SELECT slot, rating, (SELECT count(*) FROM click "
                             "WHERE click.attempt_id = attempt.id), "
                             "(SELECT min(correct) FROM response "
                             "WHERE response.attempt_id = attempt.id) FROM trial "
                             "JOIN attempt ON attempt.trial_id = trial.id "
                             "LEFT JOIN rating ON rating.attempt_id = attempt.id "
                             "WHERE enrolment_id = ? AND phase = 'practice' "
                             "AND outcome = 'completed'");
  practice.bind(1, enrolment);
  while (practice.executeStep()) {
    PracticeResult& result = history.practice[practice.getColumn(0).getInt64()];
    if (!practice.getColumn(1).isNull()) {
      result.rating = practice.getColumn(1).getInt64();
    }
    result.clicks = practice.getColumn(2).getInt64();
    if (!practice.getColumn(3).isNull()) {
      result.right = practice.getColumn(3).getInt64() != 0;
    }
  }
  history.counted_answers = load_counted_answers(database, enrolment);
  SQLite::Statement answers(database,
                            "SELECT DISTINCT question FROM answer JOIN session "
                            "ON session.id = session_id WHERE enrolment_id = ? "
                            "AND NOT (kind = 'consent' AND answer = 'declined')");
  answers.bind(1, enrolment);
  while (answers.executeStep()) {
    history.answered.insert(answers.getColumn(0).getString());
  }
  return history;
}

std::int64_t find_or_insert_participant(SQLite::Database& database, const std::string& pseudonym,
                                        bool simulated) {
  if (const auto id =
          find_id(database, "SELECT id FROM participant WHERE pseudonym = ?", pseudonym)) {
    return *id;
  }
  return insert(database, "INSERT INTO participant (pseudonym, simulated) VALUES (?, ?)", pseudonym,
                simulated ? 1 : 0);
}

std::int64_t find_or_insert_protocol(SQLite::Database& database, const ProtocolTexts& protocol) {
  if (const auto id = find_id(database, "SELECT id FROM protocol WHERE hash = ?", protocol.hash)) {
    return *id;
  }
  return insert(database,
                "INSERT INTO protocol (name, hash, protocol_json, scene_json) VALUES (?, ?, ?, ?)",
                protocol.name, protocol.hash, protocol.protocol_json, protocol.scene_json);
}

/// A track or another trial that there is none of is stored as NULL: ids and tracks are not −1.
std::int64_t insert_trial(SQLite::Database& database, std::int64_t enrolment,
                          const StoredTrial& trial) {
  return insert(database,
                "INSERT INTO trial (enrolment_id, slot, phase, repetition, condition, seed, block, "
                "catch, track, solved, yoked_trial_id) "
                "VALUES (?, ?, ?, ?, ?, ?, ?, ?, nullif(?, -1), nullif(?, ''), nullif(?, -1))",
                enrolment, trial.slot, phase_name(trial.phase), trial.repetition, trial.condition,
                static_cast<std::int64_t>(trial.seed), trial.block, trial.catch_trial ? 1 : 0,
                trial.track.value_or(-1), trial.solved, trial.yoked_trial_id.value_or(-1));
}

}  // namespace

std::vector<StoredTrial> load_trials(SQLite::Database& database, std::int64_t enrolment_id) {
  SQLite::Statement query(
      database,
      "SELECT id, slot, phase, repetition, condition, seed, block, catch, track, "
      "coalesce(adaptive_state, ''), coalesce(solved, ''), yoked_trial_id "
      "FROM trial WHERE enrolment_id = ? ORDER BY slot");
  query.bind(1, enrolment_id);
  std::vector<StoredTrial> trials;
  while (query.executeStep()) {
    const bool practice = query.getColumn(2).getString() == "practice";
    trials.push_back({query.getColumn(0).getInt64(), query.getColumn(1).getInt64(),
                      practice ? TrialPhase::kPractice : TrialPhase::kMain,
                      query.getColumn(3).getInt64(), query.getColumn(4).getString(),
                      static_cast<std::uint64_t>(query.getColumn(5).getInt64()),
                      query.getColumn(6).getInt64(), query.getColumn(7).getInt() != 0,
                      number_or_none(query, 8), query.getColumn(9).getString(),
                      query.getColumn(10).getString(), number_or_none(query, 11)});
  }
  return trials;
}

std::optional<Enrolment> find_enrolment(StudyFile& study, const std::string& pseudonym,
                                        bool simulated, const ProtocolTexts& protocol) {
  require_kind(study, pseudonym, simulated);
  SQLite::Statement query(study.database(),
                          "SELECT enrolment.id, seed, coalesce(finished_utc, ''), hash "
                          "FROM enrolment JOIN participant ON participant.id = participant_id "
                          "JOIN protocol ON protocol.id = protocol_id "
                          "WHERE pseudonym = ? AND name = ?");
  SQLite::bind(query, pseudonym, protocol.name);
  if (!query.executeStep()) {
    return std::nullopt;
  }
  const std::string finished = query.getColumn(2).getString();
  if (!finished.empty()) {
    throw InputError(study.name() + ": participant " + pseudonym + " has finished " +
                     protocol.name + " already, at " + finished);
  }
  if (query.getColumn(3).getString() != protocol.hash) {
    throw InputError(study.name() + ": participant " + pseudonym +
                     " began with another version of " + protocol.name +
                     "; resume with the file it was, or use another name");
  }
  Enrolment enrolment;
  enrolment.id = query.getColumn(0).getInt64();
  enrolment.seed = static_cast<std::uint64_t>(query.getColumn(1).getInt64());
  enrolment.trials = load_trials(study.database(), enrolment.id);
  take_yokes(study.database(), enrolment.id, enrolment.trials);
  enrolment.history = load_history(study.database(), enrolment.id);
  return enrolment;
}

bool has_finished(StudyFile& study, const std::string& pseudonym, bool simulated,
                  const ProtocolTexts& protocol) {
  SQLite::Statement query(study.database(),
                          "SELECT count(*) FROM enrolment "
                          "JOIN participant ON participant.id = participant_id "
                          "JOIN protocol ON protocol.id = protocol_id "
                          "WHERE pseudonym = ? AND simulated = ? AND hash = ? "
                          "AND finished_utc IS NOT NULL");
  SQLite::bind(query, pseudonym, simulated ? 1 : 0, protocol.hash);
  query.executeStep();
  return query.getColumn(0).getInt() > 0;
}

Enrolment enrol(StudyFile& study, const std::string& pseudonym, bool simulated,
                const ProtocolTexts& protocol, std::uint64_t seed,
                std::vector<StoredTrial> trials) {
  SQLite::Database& database = study.database();
  try {
    SQLite::Transaction transaction(database);
    const std::int64_t participant = find_or_insert_participant(database, pseudonym, simulated);
    const std::int64_t version = find_or_insert_protocol(database, protocol);
    Enrolment enrolment;
    enrolment.seed = seed;
    enrolment.id = insert(database,
                          "INSERT INTO enrolment (participant_id, protocol_id, seed, planned_utc) "
                          "VALUES (?, ?, ?, strftime('%Y-%m-%dT%H:%M:%fZ'))",
                          participant, version, static_cast<std::int64_t>(seed));
    for (StoredTrial& trial : trials) {
      trial.id = insert_trial(database, enrolment.id, trial);
    }
    store_yokes(database, enrolment.id, yokes_of(trials));
    transaction.commit();
    enrolment.trials = std::move(trials);
    return enrolment;
  } catch (const SQLite::Exception& error) {
    throw StoreError(study.name() + ": the plan could not be saved: " + error.what());
  }
}

std::map<std::string, std::string> told_demographics(StudyFile& study,
                                                     const std::string& pseudonym) {
  SQLite::Statement query(study.database(),
                          "SELECT question, words FROM questionnaire "
                          "WHERE participant = ? AND kind = 'demographic'");
  query.bind(1, pseudonym);
  std::map<std::string, std::string> told;
  while (query.executeStep()) {
    told[query.getColumn(0).getString()] = query.getColumn(1).getString();
  }
  return told;
}

std::vector<std::string> other_versions(StudyFile& study, const ProtocolTexts& protocol) {
  SQLite::Statement query(study.database(),
                          "SELECT hash FROM protocol WHERE name = ? AND hash <> ?");
  SQLite::bind(query, protocol.name, protocol.hash);
  std::vector<std::string> hashes;
  while (query.executeStep()) {
    hashes.push_back(query.getColumn(0).getString());
  }
  return hashes;
}

}  // namespace impetus::inline store
