// SPDX-License-Identifier: MIT
#include "experiments/store/exclusion.hpp"

#include <SQLiteCpp/Transaction.h>

#include <algorithm>

#include "experiments/settings/input_error.hpp"
#include "experiments/store/rows.hpp"

namespace impetus::inline store {
namespace {

std::int64_t participant_id(StudyFile& study, const std::string& pseudonym) {
  const auto id = load_value<std::int64_t>(
      study.database(), "SELECT id FROM participant WHERE pseudonym = ?", pseudonym);
  if (!id) {
    throw InputError(study.name() + ": expected a participant of the study, got " + pseudonym);
  }
  return *id;
}

void require_trial(StudyFile& study, std::int64_t participant, const Exclusion& exclusion) {
  if (!load_value<int>(study.database(),
                       "SELECT 1 FROM trial JOIN enrolment ON enrolment.id = enrolment_id "
                       "WHERE trial.id = ? AND participant_id = ?",
                       *exclusion.trial_id, participant)) {
    throw InputError(study.name() + ": expected a trial of " + exclusion.participant + ", got " +
                     std::to_string(*exclusion.trial_id));
  }
}

bool is_excluded(StudyFile& study, const Exclusion& exclusion) {
  const auto excluded = load_column<std::optional<std::int64_t>>(
      study.database(), "SELECT trial FROM excluded WHERE participant = ?", exclusion.participant);
  return std::find(excluded.begin(), excluded.end(), exclusion.trial_id) != excluded.end();
}

std::string what(const Exclusion& exclusion) {
  return exclusion.trial_id
             ? "trial " + std::to_string(*exclusion.trial_id) + " of " + exclusion.participant
             : exclusion.participant;
}

}  // namespace

std::int64_t require_excludable(StudyFile& study, const Exclusion& exclusion) {
  const std::int64_t participant = participant_id(study, exclusion.participant);
  if (exclusion.trial_id) {
    require_trial(study, participant, exclusion);
  }
  if (is_excluded(study, exclusion) == exclusion.excluded) {
    throw InputError(study.name() + ": " + what(exclusion) +
                     (exclusion.excluded ? " is excluded already" : " is not excluded"));
  }
  return participant;
}

void exclude(StudyFile& study, const Exclusion& exclusion) {
  const std::int64_t participant = require_excludable(study, exclusion);
  SQLite::Transaction transaction(study.database());
  insert_row(study.database(), "exclusion",
             {{"participant_id", participant},
              {"trial_id", exclusion.trial_id},
              {"excluded", exclusion.excluded},
              {"reason", exclusion.reason},
              {"decided_utc", Now()}});
  transaction.commit();
}

}  // namespace impetus::inline store
