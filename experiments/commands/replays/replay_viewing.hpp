// `impetus replay --view`: recorded trials in the viewer's window.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "experiments/store/study_reader.hpp"

namespace impetus::inline commands {

/// Plays the attempts one by one until the viewer is closed; returns the exit status.
int view_attempts(StudyFile& study, const std::vector<StoredAttempt>& attempts,
                  const std::string& window_size);

}  // namespace impetus::inline commands
