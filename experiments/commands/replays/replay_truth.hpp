// `impetus replay --truth`: fills the study's table of what was wrong with each collision.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/store/study_reader.hpp"

namespace impetus::inline commands {

/// Measures every recorded collision of the attempts and stores it; returns the exit status. A
/// trial that diverges is named and left without truth. `study` must be open for writing.
int fill_truth(StudyFile& study, const std::vector<StoredAttempt>& attempts);

}  // namespace impetus::inline commands
