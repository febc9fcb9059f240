// SPDX-License-Identifier: MIT
#include "experiments/commands/enrolling.hpp"

#include <cstdio>
#include <string>
#include <utility>

#include "experiments/commands/stored_plan.hpp"
#include "experiments/commands/yoking.hpp"
#include "experiments/protocol/protocol_checks.hpp"

namespace impetus {

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

}  // namespace impetus
