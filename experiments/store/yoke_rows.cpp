// SPDX-License-Identifier: MIT
#include "experiments/store/yoke_rows.hpp"

#include <utility>

#include "experiments/settings/input_error.hpp"
#include "experiments/store/rows.hpp"

namespace impetus::inline store {
namespace {

constexpr const char* kFinished =
    "SELECT enrolment.id, pseudonym, protocol_id FROM enrolment "
    "JOIN participant ON participant.id = participant_id "
    "JOIN protocol ON protocol.id = protocol_id "
    "WHERE finished_utc IS NOT NULL AND protocol.name = ? AND pseudonym ";

constexpr const char* kOthers =
    "<> ? AND participant.simulated = ? AND (?4 = '' OR EXISTS (SELECT 1 FROM trial "
    "WHERE enrolment_id = enrolment.id AND condition = ?4)) AND pseudonym NOT IN "
    "(SELECT participant FROM excluded WHERE trial IS NULL) ORDER BY ";

template <typename... Values>
std::optional<YokePartner> first_partner(StudyFile& study, const std::string& sql,
                                         const Values&... values) {
  auto found = load_as<YokePartner, std::int64_t, std::string, std::int64_t>(study.database(), sql,
                                                                             values...);
  return found.empty() ? std::nullopt : std::optional(std::move(found.front()));
}

}  // namespace

bool has_participant(StudyFile& study, const std::string& pseudonym) {
  return load_value<int>(study.database(), "SELECT 1 FROM participant WHERE pseudonym = ?",
                         pseudonym)
      .has_value();
}

std::optional<YokePartner> finished_partner(StudyFile& study, const std::string& pseudonym,
                                            const std::string& protocol) {
  return first_partner(study, std::string(kFinished) + "= ? ORDER BY enrolment.id DESC", protocol,
                       pseudonym);
}

std::optional<YokePartner> last_partner(StudyFile& study, const std::string& protocol,
                                        const std::string& but, bool simulated,
                                        const std::string& followed) {
  return first_partner(study,
                       std::string(kFinished) + kOthers + "finished_utc DESC, enrolment.id DESC",
                       protocol, but, simulated ? 1 : 0, followed);
}

std::optional<YokePartner> least_followed_partner(StudyFile& study, const std::string& protocol,
                                                  const std::string& but, bool simulated,
                                                  const std::string& followed) {
  return first_partner(study,
                       std::string(kFinished) + kOthers +
                           "(SELECT count(DISTINCT follower.enrolment_id) FROM trial AS followed "
                           "JOIN trial AS follower ON follower.yoked_trial_id = followed.id "
                           "WHERE followed.enrolment_id = enrolment.id), enrolment.id",
                       protocol, but, simulated ? 1 : 0, followed);
}

std::vector<YokeSource> yoke_sources(StudyFile& study, const YokePartner& partner) {
  std::vector<YokeSource> sources;
  for (const auto& [id, slot, phase, repetition, catch_trial, condition, completed] :
       load_rows<std::int64_t, std::int64_t, std::string, std::int64_t, bool, std::string, bool>(
           study.database(),
           "SELECT id, slot, phase, repetition, catch, condition, "
           "EXISTS (SELECT 1 FROM attempt WHERE trial_id = trial.id "
           "AND outcome = 'completed') FROM trial WHERE enrolment_id = ? ORDER BY slot",
           partner.enrolment_id)) {
    sources.push_back(
        {id, slot, phase_named(phase), repetition, catch_trial, condition, completed});
  }
  return sources;
}

GazePath load_gaze_path(StudyFile& study, std::int64_t trial_id) {
  GazePath path;
  if (load_value<bool>(study.database(),
                       "SELECT 1 FROM step JOIN attempt ON attempt.id = attempt_id "
                       "WHERE trial_id = ? AND outcome = 'completed' AND interval = 2 LIMIT 1",
                       trial_id)) {
    throw InputError(study.name() + ": trial " + std::to_string(trial_id) +
                     ": expected a trial of one stimulus to follow, got one of two");
  }
  for (const auto& [distance_m, x_m, y_m] : load_rows<double, std::optional<double>, double>(
           study.database(),
           "SELECT viewing_distance_m, fixation_x_m, fixation_y_m FROM attempt "
           "JOIN session ON session.id = session_id JOIN step ON step.attempt_id = attempt.id "
           "WHERE trial_id = ? AND outcome = 'completed' AND interval = 1 ORDER BY step",
           trial_id)) {
    path.viewing_distance_m = distance_m;
    path.fixations.push_back(x_m ? Fixation({*x_m, y_m}) : std::nullopt);
  }
  return path;
}

}  // namespace impetus::inline store
