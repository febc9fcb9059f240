// A demonstration: a scene that is shown before practice, named beforehand, without a task.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "experiments/record/script.hpp"
#include "experiments/session/trial.hpp"

namespace impetus::inline session {

/// Plays a demonstration once, after an interval; nothing of it is recorded. Returns what
/// interrupted it.
Interruption show_demonstration(const std::string& id, const Script& script,
                                const SessionProgress& progress, const Ports& ports);

}  // namespace impetus::inline session
