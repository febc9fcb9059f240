// SPDX-License-Identifier: MIT
#include "experiments/commands/running/unattended_run.hpp"
#include "experiments/commands/build_name.hpp"

#include <optional>
#include <string>
#include <utility>

#include "experiments/commands/machine_name.hpp"
#include "experiments/commands/progress_line.hpp"
#include "experiments/commands/running/enrolling.hpp"
#include "experiments/commands/running/session_warnings.hpp"
#include "experiments/protocol/protocol_scenes.hpp"
#include "experiments/protocol/screen_file.hpp"
#include "experiments/session/unattended.hpp"
#include "experiments/store/study_writer.hpp"
#include "experiments/study/stored_plan.hpp"

namespace impetus::inline commands {
namespace {

/// Of a sitting without display and participant, before an assumed screen.
SessionFacts facts_without_laboratory() {
  constexpr double kNominalHz = 60.0;  // of frames that there are none of
  SessionFacts facts;
  facts.build = build_name();
  facts.machine = machine_name();
  facts.display = "none: simulated, and shown to nobody";
  facts.simulated = true;
  facts.screen = assumed_screen();
  facts.refresh_hz = kNominalHz;
  facts.sync.passed = true;
  return facts;
}

}  // namespace

RunOptions as_nobody(RunOptions options) {
  const std::pair<const char*, bool> given[] = {{"--participant", !options.participant.empty()},
                                                {"--participants", options.participants > 0},
                                                {"--observer", options.simulated()},
                                                {"--show", options.show}};
  for (const auto& [name, is_given] : given) {
    if (is_given) {
      throw InputError(std::string(name) + ": expected none, for nobody takes part in " +
                       options.protocol);
    }
  }
  options.participant = "nobody";
  options.observers = {"nobody"};
  return options;
}

std::int64_t run_unattended_part(const RunPart& part, const RunOptions& options, StudyFile& study) {
  const std::optional<Enrolment> resumed = find_to_resume(study, part, options);
  const Enrolment enrolment =
      resumed ? *resumed : enrol_anew(study, part, options, new_plan(study, part, options));
  StudyWriter writer(study, enrolment, facts_without_laboratory());
  const ProtocolScenes scenes(part.protocol, 0.0, part.shapes);
  ProgressLine line("simulating");
  run_unattended(planned(enrolment.trials, part.protocol.design), enrolment.history, scenes,
                 assumed_screen(), writer, [&line](double share) { line.tell(share); });
  writer.end("finished");
  tell_not_finite(writer);
  return writer.session_id();
}

}  // namespace impetus::inline commands
