// SPDX-License-Identifier: MIT
#include "experiments/commands/unattended_run.hpp"

#include "experiments/commands/progress_line.hpp"
#include "experiments/protocol/screen_file.hpp"
#include "experiments/session/unattended.hpp"

namespace impetus {

SessionFacts facts_without_laboratory(const std::string& build, const std::string& machine) {
  constexpr double kNominalHz = 60.0;  // of frames that there are none of
  SessionFacts facts;
  facts.build = build;
  facts.machine = machine;
  facts.display = "none: simulated, and shown to nobody";
  facts.simulated = true;
  facts.screen = assumed_screen();
  facts.refresh_hz = kNominalHz;
  facts.sync.passed = true;
  return facts;
}

void simulate_unattended(const Plan& plan, const SessionHistory& history, const Scenes& scenes,
                         StudyWriter& writer) {
  ProgressLine line("simulating");
  run_unattended(plan, history, scenes, assumed_screen(), writer,
                 [&line](double share) { line.tell(share); });
  writer.end("finished");
}

}  // namespace impetus
