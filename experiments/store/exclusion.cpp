// SPDX-License-Identifier: MIT
#include "experiments/store/exclusion.hpp"

#include <SQLiteCpp/Statement.h>
#include <SQLiteCpp/Transaction.h>

#include "experiments/settings/input_error.hpp"

namespace impetus::inline store {
namespace {

std::int64_t participant_id(StudyFile& study, const std::string& pseudonym) {
  SQLite::Statement query(study.database(), "SELECT id FROM participant WHERE pseudonym = ?");
  query.bind(1, pseudonym);
  if (!query.executeStep()) {
    throw InputError(study.name() + ": expected a participant of the study, got " + pseudonym);
  }
  return query.getColumn(0).getInt64();
}

void require_trial(StudyFile& study, std::int64_t participant, const Exclusion& exclusion) {
  SQLite::Statement query(study.database(),
                          "SELECT 1 FROM trial JOIN enrolment ON enrolment.id = enrolment_id "
                          "WHERE trial.id = ? AND participant_id = ?");
  query.bind(1, *exclusion.trial_id);
  query.bind(2, participant);
  if (!query.executeStep()) {
    throw InputError(study.name() + ": expected a trial of " + exclusion.participant + ", got " +
                     std::to_string(*exclusion.trial_id));
  }
}

bool is_excluded(StudyFile& study, const Exclusion& exclusion) {
  SQLite::Statement query(study.database(),
                          "SELECT 1 FROM excluded WHERE participant = ? AND trial IS ?");
  query.bind(1, exclusion.participant);
  if (exclusion.trial_id) {
    query.bind(2, *exclusion.trial_id);
  }
  return query.executeStep();
}

std::string what(const Exclusion& exclusion) {
  return exclusion.trial_id
             ? "trial " + std::to_string(*exclusion.trial_id) + " of " + exclusion.participant
             : exclusion.participant;
}

}  // namespace

void exclude(StudyFile& study, const Exclusion& exclusion) {
  const std::int64_t participant = participant_id(study, exclusion.participant);
  if (exclusion.trial_id) {
    require_trial(study, participant, exclusion);
  }
  if (is_excluded(study, exclusion) == exclusion.excluded) {
    throw InputError(study.name() + ": " + what(exclusion) +
                     (exclusion.excluded ? " is excluded already" : " is not excluded"));
  }
  SQLite::Transaction transaction(study.database());
  SQLite::Statement insert(study.database(),
                           "INSERT INTO exclusion (participant_id, trial_id, excluded, reason, "
                           "decided_utc) VALUES (?, ?, ?, ?, strftime('%Y-%m-%dT%H:%M:%fZ'))");
  insert.bind(1, participant);
  if (exclusion.trial_id) {
    insert.bind(2, *exclusion.trial_id);
  }
  insert.bind(3, exclusion.excluded ? 1 : 0);
  insert.bind(4, exclusion.reason);
  insert.exec();
  transaction.commit();
}

}  // namespace impetus::inline store
