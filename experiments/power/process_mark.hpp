// Which process something belongs to, told apart from a later one that was given the same number.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace impetus::inline power {

/// This process on this machine since it was started: "boot id:process id:start".
std::string mark_of_this_process();

/// Whether words could be the mark of a process, of any machine.
bool is_process_mark(const std::string& words);

/// Whether the process of `mark` still runs. False for words that are no mark.
bool still_runs(const std::string& mark);

}  // namespace impetus::inline power
