// `impetus run` of a protocol in which nobody takes part: what it stores, and its progress.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "experiments/session/plan.hpp"
#include "experiments/session/ports.hpp"
#include "experiments/session/session_standing.hpp"
#include "experiments/store/study_writer.hpp"

namespace impetus {

/// Of a sitting without display and participant, before an assumed screen.
SessionFacts facts_without_laboratory(const std::string& build, const std::string& machine);

/// Runs the trials that are left, with a line of progress, and ends the session as finished.
void simulate_unattended(const Plan& plan, const SessionHistory& history, const Scenes& scenes,
                         StudyWriter& writer);

}  // namespace impetus
