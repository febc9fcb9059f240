// Every trial of a study simulated again, as a check of its verification.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/store/study_file.hpp"
#include "experiments/study/verification.hpp"

namespace impetus::inline commands {

/// Compares each step of every attempt bit for bit, the last step of those that nobody was shown
/// with the stimulus's length, and every adaptive level with what its track chooses anew.
VerificationCheck check_replay(StudyFile& study);

}  // namespace impetus::inline commands
