// `impetus run` of a protocol in which nobody takes part: its trials are simulated and stored.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "experiments/commands/running/run_options.hpp"
#include "experiments/store/study_file.hpp"

namespace impetus::inline commands {

/// The options with nobody, a simulated participant, as who takes part. Throws InputError when they
/// name somebody.
RunOptions as_nobody(RunOptions options);

/// Runs the trials that are left, with a line of progress, before an assumed screen. `options` are
/// as_nobody()'s. Returns the session that was saved. Throws what the recorder throws.
std::int64_t run_unattended_part(const RunPart& part, const RunOptions& options, StudyFile& study);

}  // namespace impetus::inline commands
