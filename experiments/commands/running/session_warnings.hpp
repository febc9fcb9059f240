// A word, when a session has ended, on what an experimenter should know of its data.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/session/session.hpp"
#include "experiments/store/study_writer.hpp"

namespace impetus::inline commands {

/// Warns on standard error of trials in which a body's state was no longer finite.
void tell_not_finite(const StudyWriter& writer);

/// Warns of timed frames that were late, of gaze shown late or lost, and of states not finite.
/// Nothing where all went well.
void tell_warnings(const SessionResult& result, const StudyWriter& writer);

}  // namespace impetus::inline commands
