// A participant comes back: whether that is allowed, and where the new session begins.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "experiments/design/plan.hpp"
#include "experiments/protocol/protocol_file.hpp"
#include "experiments/store/enrolment.hpp"
#include "experiments/store/session_rows.hpp"

namespace impetus::inline study {

/// "3.2 h" or "12 min".
std::string duration_words(double seconds);

/// How a new session goes on with what the enrolment's earlier ones left; the history of the
/// enrolment becomes what it goes on from. None: there was no session. Throws InputError when it
/// was left for longer than the protocol allows.
std::optional<ResumedSession> take_up(StudyFile& study, const Protocol& protocol,
                                      const std::string& participant, const Plan& plan,
                                      Enrolment& enrolment);

}  // namespace impetus::inline study
