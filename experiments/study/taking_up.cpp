// SPDX-License-Identifier: MIT
#include "experiments/study/taking_up.hpp"

#include <cmath>
#include <sstream>

#include "experiments/settings/input_error.hpp"

namespace impetus::inline study {
namespace {

/// Once resuming is refused after some age, that age must be known.
void require_young(const StudyFile& study, const Protocol& protocol, const std::string& participant,
                   double age_s) {
  const double limit_s = protocol.script.resume.refuse_after_h * 3600.0;
  const std::string who = study.name() + ": participant " + participant;
  if (limit_s > 0.0 && age_s < 0.0) {
    throw InputError(who + "'s last record lies " + duration_words(-age_s) +
                     " ahead of this machine's clock, so that the age after which " +
                     protocol.name + " is not resumed cannot be told; set the clock right");
  }
  if (limit_s > 0.0 && age_s > limit_s) {
    throw InputError(who + " left " + protocol.name + " " + duration_words(age_s) +
                     " ago; it is resumed within " + duration_words(limit_s) +
                     " (/session/resume/refuse_after_h), then no more");
  }
}

}  // namespace

std::string duration_words(double seconds) {
  constexpr double kMinute_s = 60.0;
  constexpr double kHour_s = 3600.0;
  std::ostringstream words;
  words.precision(3);
  if (seconds < kHour_s) {
    words << std::ceil(seconds / kMinute_s) << " min";
  } else {
    words << seconds / kHour_s << " h";
  }
  return words.str();
}

std::optional<ResumedSession> take_up(StudyFile& study, const Protocol& protocol,
                                      const std::string& participant, const Plan& plan,
                                      Enrolment& enrolment) {
  const auto age_s = seconds_since_recorded(study.database(), enrolment.id);
  if (!age_s) {
    return std::nullopt;
  }
  require_young(study, protocol, participant, *age_s);
  const ResumeRule& rule = protocol.script.resume;
  return ResumedSession{rule.at, age_s, resume(protocol.script, plan, enrolment.history)};
}

}  // namespace impetus::inline study
