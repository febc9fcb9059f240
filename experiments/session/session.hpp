// A session: one participant, from welcome to thanks, or as far as they come.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/design/plan.hpp"
#include "experiments/record/script.hpp"
#include "experiments/session/conversation.hpp"
#include "experiments/session/session_standing.hpp"
#include "experiments/session/trial.hpp"
#include "experiments/session/trial_sequence.hpp"

namespace impetus::inline session {

/// How a session ended and how far it came.
struct SessionResult {
  SessionEnding ending{SessionEnding::kQuit};
  std::int64_t completed_trials{0};  ///< practice included, earlier sessions included
  std::int64_t expected_trials{0};   ///< in all; rounds of practice that nobody needs not included
  GazeTroubles gaze;                 ///< of this session
};

/// Welcomes, asks consent and demographics, instructs, calibrates the gaze, demonstrates, practises
/// (until it is understood, or enough answers were right, where the script says so, or a person
/// decides), runs the trials with breaks, asks the questions, thanks. What `history` has is not
/// asked or shown again; instructions are. Everything acknowledged is on disk before the next trial
/// is shown. `design`, of which `plan` was made, is needed where it is adaptive. Throws what the
/// recorder throws.
SessionResult run_session(const Script& script, const Plan& plan, const SessionHistory& history,
                          const Ports& ports, const Design& design = {});

}  // namespace impetus::inline session
