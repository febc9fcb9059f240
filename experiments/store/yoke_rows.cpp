// SPDX-License-Identifier: MIT
#include "experiments/store/yoke_rows.hpp"

#include <SQLiteCpp/Statement.h>
#include <SQLiteCpp/VariadicBind.h>

namespace impetus::inline store {
namespace {

constexpr const char* kFinished =
    "SELECT enrolment.id, pseudonym, protocol_id FROM enrolment "
    "JOIN participant ON participant.id = participant_id "
    "JOIN protocol ON protocol.id = protocol_id "
    "WHERE finished_utc IS NOT NULL AND protocol.name = ? AND pseudonym ";

constexpr const char* kOthers = "<> ? AND participant.simulated = ? ORDER BY ";

std::optional<YokePartner> first_of(SQLite::Statement& query) {
  if (!query.executeStep()) {
    return std::nullopt;
  }
  return YokePartner{query.getColumn(0).getInt64(), query.getColumn(1).getString(),
                     query.getColumn(2).getInt64()};
}

}  // namespace

bool has_participant(StudyFile& study, const std::string& pseudonym) {
  SQLite::Statement query(study.database(), "SELECT 1 FROM participant WHERE pseudonym = ?");
  query.bind(1, pseudonym);
  return query.executeStep();
}

std::optional<YokePartner> finished_partner(StudyFile& study, const std::string& pseudonym,
                                            const std::string& protocol) {
  SQLite::Statement query(study.database(),
                          std::string(kFinished) + "= ? ORDER BY enrolment.id DESC");
  SQLite::bind(query, protocol, pseudonym);
  return first_of(query);
}

std::optional<YokePartner> last_partner(StudyFile& study, const std::string& protocol,
                                        const std::string& but, bool simulated) {
  SQLite::Statement query(
      study.database(), std::string(kFinished) + kOthers + "finished_utc DESC, enrolment.id DESC");
  SQLite::bind(query, protocol, but, simulated ? 1 : 0);
  return first_of(query);
}

std::optional<YokePartner> least_followed_partner(StudyFile& study, const std::string& protocol,
                                                  const std::string& but, bool simulated) {
  SQLite::Statement query(
      study.database(), std::string(kFinished) + kOthers +
                            "(SELECT count(DISTINCT follower.enrolment_id) FROM trial AS followed "
                            "JOIN trial AS follower ON follower.yoked_trial_id = followed.id "
                            "WHERE followed.enrolment_id = enrolment.id), enrolment.id");
  SQLite::bind(query, protocol, but, simulated ? 1 : 0);
  return first_of(query);
}

std::vector<YokeSource> yoke_sources(StudyFile& study, const YokePartner& partner) {
  SQLite::Statement query(study.database(),
                          "SELECT id, slot, phase, repetition, catch, condition, "
                          "EXISTS (SELECT 1 FROM attempt WHERE trial_id = trial.id "
                          "AND outcome = 'completed') FROM trial "
                          "WHERE enrolment_id = ? ORDER BY slot");
  query.bind(1, partner.enrolment_id);
  std::vector<YokeSource> sources;
  while (query.executeStep()) {
    const bool practice = query.getColumn(2).getString() == "practice";
    sources.push_back({query.getColumn(0).getInt64(), query.getColumn(1).getInt64(),
                       practice ? TrialPhase::kPractice : TrialPhase::kMain,
                       query.getColumn(3).getInt64(), query.getColumn(4).getInt() != 0,
                       query.getColumn(5).getString(), query.getColumn(6).getInt() != 0});
  }
  return sources;
}

GazePath load_gaze_path(StudyFile& study, std::int64_t trial_id) {
  SQLite::Statement query(
      study.database(),
      "SELECT viewing_distance_m, fixation_x_m, fixation_y_m FROM attempt "
      "JOIN session ON session.id = session_id JOIN step ON step.attempt_id = attempt.id "
      "WHERE trial_id = ? AND outcome = 'completed' AND interval = 1 ORDER BY step");
  query.bind(1, trial_id);
  GazePath path;
  while (query.executeStep()) {
    path.viewing_distance_m = query.getColumn(0).getDouble();
    const bool known = !query.getColumn(1).isNull();
    path.fixations.push_back(
        known ? Fixation({query.getColumn(1).getDouble(), query.getColumn(2).getDouble()})
              : std::nullopt);
  }
  return path;
}

void store_yokes(SQLite::Database& database, std::int64_t enrolment_id, const Yokes& yokes) {
  SQLite::Statement update(
      database, "UPDATE trial SET yoked_trial_id = ? WHERE enrolment_id = ? AND slot = ?");
  for (const auto& [slot, followed] : yokes) {
    SQLite::bind(update, followed, enrolment_id, slot);
    update.exec();
    update.reset();
  }
}

Yokes load_yokes(SQLite::Database& database, std::int64_t enrolment_id) {
  SQLite::Statement query(database,
                          "SELECT slot, yoked_trial_id FROM trial "
                          "WHERE enrolment_id = ? AND yoked_trial_id IS NOT NULL");
  query.bind(1, enrolment_id);
  Yokes yokes;
  while (query.executeStep()) {
    yokes[query.getColumn(0).getInt64()] = query.getColumn(1).getInt64();
  }
  return yokes;
}

}  // namespace impetus::inline store
