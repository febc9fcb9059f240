// Whose trials others are yoked to: who may be followed, what they did, and what was decided.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "experiments/design/plan.hpp"
#include "experiments/record/gaze.hpp"
#include "experiments/store/study_file.hpp"

namespace impetus::inline store {

/// A finished enrolment, whose trials may be followed.
struct YokePartner {
  std::int64_t enrolment_id{0};
  std::string pseudonym;
  std::int64_t protocol_id{0};
};

/// One of its trials.
struct YokeSource {
  std::int64_t trial_id{0};
  std::int64_t slot{0};
  TrialPhase phase{TrialPhase::kMain};
  std::int64_t repetition{1};
  bool catch_trial{false};
  std::string condition;  ///< JSON
  bool completed{false};
};

/// Whether the study knows the participant.
bool has_participant(StudyFile& study, const std::string& pseudonym);

/// The participant's finished enrolment in a protocol of that name.
std::optional<YokePartner> finished_partner(StudyFile& study, const std::string& pseudonym,
                                            const std::string& protocol);

/// Of those of one kind (simulated or not) who have finished and whom the analysis does not leave
/// out, with trials under the condition `followed` (JSON; "": any), but for `but`: the last one.
std::optional<YokePartner> last_partner(StudyFile& study, const std::string& protocol,
                                        const std::string& but, bool simulated,
                                        const std::string& followed);

/// The same, the first whom the fewest others are yoked to.
std::optional<YokePartner> least_followed_partner(StudyFile& study, const std::string& protocol,
                                                  const std::string& but, bool simulated,
                                                  const std::string& followed);

/// The partner's trials in the order of the plan.
std::vector<YokeSource> yoke_sources(StudyFile& study, const YokePartner& partner);

/// The fixations that the steps of the trial's completed attempt used. Throws SQLite::Exception.
GazePath load_gaze_path(StudyFile& study, std::int64_t trial_id);

}  // namespace impetus::inline store
