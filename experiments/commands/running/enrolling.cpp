// SPDX-License-Identifier: MIT
#include "experiments/commands/running/enrolling.hpp"

#include <cmath>
#include <cstdio>
#include <sstream>
#include <string>
#include <utility>

#include "experiments/commands/running/yoking.hpp"
#include "experiments/protocol/checks/protocol_checks.hpp"
#include "experiments/record/lab_screen.hpp"
#include "experiments/store/session_rows.hpp"
#include "experiments/study/stored_plan.hpp"

namespace impetus::inline commands {
namespace {

/// "3.2 h" or "12 min".
std::string duration(double seconds) {
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

/// Once resuming is refused after some age, that age must be known.
void require_young(const StudyFile& study, const RunPart& part, const RunOptions& options,
                   double age_s) {
  const double limit_s = part.protocol.script.resume.refuse_after_h * 3600.0;
  const std::string who = study.name() + ": participant " + options.participant;
  if (limit_s > 0.0 && age_s < 0.0) {
    throw InputError(who + "'s last record lies " + duration(-age_s) +
                     " ahead of this machine's clock, so that the age after which " +
                     part.protocol.name + " is not resumed cannot be told; set the clock right");
  }
  if (limit_s > 0.0 && age_s > limit_s) {
    throw InputError(who + " left " + part.protocol.name + " " + duration(age_s) +
                     " ago; it is resumed within " + duration(limit_s) +
                     " (/session/resume/refuse_after_h), then no more");
  }
}

}  // namespace

std::optional<ResumedSession> take_up(StudyFile& study, const RunPart& part,
                                      const RunOptions& options, const Plan& plan,
                                      Enrolment& enrolment) {
  const auto age_s = seconds_since_recorded(study.database(), enrolment.id);
  if (!age_s) {
    return std::nullopt;
  }
  require_young(study, part, options, *age_s);
  if (*age_s < 0.0) {
    std::fprintf(stderr,
                 "warning: the last record of %s lies %s ahead of this machine's clock, which may "
                 "have been set back; the gap is stored as it is\n",
                 options.participant.c_str(), duration(-*age_s).c_str());
  }
  const ResumeRule& rule = part.protocol.script.resume;
  return ResumedSession{rule.at, *age_s, resume(rule, plan, enrolment.history)};
}

std::string change_of_screen(StudyFile& study, const RunOptions& options,
                             const Enrolment& enrolment, const ScreenGeometry& screen) {
  const auto last = last_screen(study.database(), enrolment.id);
  if (!last || is_same_screen(*last, screen)) {
    return "";
  }
  const std::string now = screen_words(screen);
  if (!options.changed_screen) {
    throw InputError(study.name() + ": participant " + options.participant +
                     " goes on: expected the screen of the session before (" + screen_words(*last) +
                     "), got " + now +
                     "; --changed-screen goes on with this one, and keeps a note");
  }
  return now + "; in the session before " + screen_words(*last);
}

std::optional<Enrolment> find_to_resume(StudyFile& study, const RunPart& part,
                                        const RunOptions& options) {
  auto found =
      find_enrolment(study, options.participant, options.simulated(), texts_of(part.protocol));
  if (found && options.seed && *options.seed != found->seed) {
    throw InputError("--seed " + std::to_string(*options.seed) + ": expected " +
                     std::to_string(found->seed) + ", with which " + options.participant +
                     "'s trials were planned");
  }
  return found;
}

Plan new_plan(StudyFile& study, const RunPart& part, const RunOptions& options) {
  Plan plan = plan_for(part.protocol, options.participant, options.seed.value_or(1));
  put_solved(part.solved, plan);
  return yoked(std::move(plan), study, part.protocol, options.participant, options.simulated());
}

Enrolment enrol_anew(StudyFile& study, const RunPart& part, const RunOptions& options,
                     const Plan& plan) {
  const ProtocolTexts texts = texts_of(part.protocol);
  for (const std::string& hash : other_versions(study, texts)) {
    std::fprintf(stderr, "note: %s also holds another version of %s (%s)\n", study.name().c_str(),
                 texts.name.c_str(), hash.c_str());
  }
  return enrol(study, options.participant, options.simulated(), texts, options.seed.value_or(1),
               stored(plan));
}

}  // namespace impetus::inline commands
