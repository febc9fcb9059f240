// Who does which protocol: the plan, stored whole before the first trial is shown.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "experiments/design/plan.hpp"
#include "experiments/session/session.hpp"
#include "experiments/store/study_file.hpp"

namespace impetus::inline store {

/// A version of a protocol as a study keeps it: what was read, byte for byte.
struct ProtocolTexts {
  std::string name;
  std::string hash;
  std::string protocol_json;
  std::string scene_json;
};

/// A planned trial as the file keeps it; the condition is JSON text.
struct StoredTrial {
  std::int64_t id{0};
  std::int64_t slot{0};
  TrialPhase phase{TrialPhase::kMain};
  std::int64_t repetition{1};
  std::string condition;
  std::uint64_t seed{0};
  std::int64_t block{1};
  bool catch_trial{false};
  std::optional<std::int64_t> track{};
  std::string adaptive_state{};  ///< JSON text; "" until the level is chosen
  std::string solved{};          ///< JSON text {"/pointer": number}; "": nothing
  std::optional<std::int64_t> yoked_trial_id{};
};

/// A participant in a protocol: the plan, and what was done of it.
struct Enrolment {
  std::int64_t id{0};
  std::uint64_t seed{0};
  std::vector<StoredTrial> trials;
  SessionHistory history;
};

/// A participant who is to be enrolled, and the plan.
struct NewEnrolment {
  std::string pseudonym;
  bool simulated{false};
  ProtocolTexts protocol;
  std::uint64_t seed{0};
  std::vector<StoredTrial> trials;
};

/// The plan of an enrolment, by slot. Throws SQLite::Exception.
std::vector<StoredTrial> load_trials(SQLite::Database& database, std::int64_t enrolment_id);

/// The enrolment of this id. Throws SQLite::Exception.
Enrolment load_enrolment(StudyFile& study, std::int64_t id);

/// The participant's enrolment in a protocol of this version, if there is one. Throws InputError
/// when it is finished, was made with another version of the protocol, or when the pseudonym
/// belongs to a participant of the other kind (simulated or not).
std::optional<Enrolment> find_enrolment(StudyFile& study, const std::string& pseudonym,
                                        bool simulated, const ProtocolTexts& protocol);

/// Whether the participant has finished this version of the protocol, simulated or not as said.
bool has_finished(StudyFile& study, const std::string& pseudonym, bool simulated,
                  const ProtocolTexts& protocol);

/// Stores participant, protocol and plan as part of a transaction that is going on. Ids of the
/// trials are filled in. Throws SQLite::Exception.
Enrolment insert_enrolment(SQLite::Database& database, NewEnrolment fresh);

/// The same in one transaction. Throws StoreError.
Enrolment enrol(StudyFile& study, const std::string& pseudonym, bool simulated,
                const ProtocolTexts& protocol, std::uint64_t seed, std::vector<StoredTrial> trials);

/// The conditions, as JSON, of the first trials of those who have a plan of a protocol of this
/// name, simulated or not as said, in the order of their enrolment; who declined or is left out of
/// the analysis is not among them.
std::vector<std::string> first_conditions(StudyFile& study, const std::string& protocol,
                                          bool simulated);

/// What the participant told of themselves in any protocol of the study: the words that were asked,
/// by the question's id.
std::map<std::string, std::string> told_demographics(StudyFile& study,
                                                     const std::string& pseudonym);

/// Hashes of other versions of the protocol that the study holds.
std::vector<std::string> other_versions(StudyFile& study, const ProtocolTexts& protocol);

}  // namespace impetus::inline store
