// `impetus replay --with`: what would have happened in the recorded trials under other settings.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "experiments/store/study_reader.hpp"

namespace impetus::inline commands {

/// What `impetus replay --with` was asked for.
struct ReplayWithOptions {
  std::vector<std::string> with;  ///< "KEY=VALUE", in the order given
  std::string csv_file;           ///< a row a trial; "": none
  std::string json_file;          ///< everything; "": none
};

/// The keys that --with takes, for the command's help.
std::string words_of_setting_keys();

/// Simulates the attempts as they were and as they would have been, prints a table and writes the
/// files; returns the exit status. A trial that diverges is named and left out. Throws InputError,
/// before anything is simulated, when a setting or a file is not to be had.
int replay_with(StudyFile& study, const std::vector<StoredAttempt>& attempts,
                const ReplayWithOptions& options);

}  // namespace impetus::inline commands
