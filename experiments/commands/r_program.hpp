// R scripts, run by the Rscript of the user's path.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace impetus::inline commands {

inline constexpr int kNoRscript = 127;

/// Runs a script and its arguments, `words`, and waits for its end; what it says goes to stderr.
/// Its exit status; kNoRscript when there is no Rscript; −1 when a signal ended it.
int run_r_script(const std::vector<std::string>& words);

/// The same for what cannot be done without R: throws InputError when there is no Rscript.
int run_needed_r_script(const std::vector<std::string>& words);

}  // namespace impetus::inline commands
