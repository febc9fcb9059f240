// How long something takes, in words.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace impetus::inline commands {

/// "0.4 s", "50 s", "12 min", "3 h 20 min", "2 days 5 h"; `seconds` ≥ 0.
std::string duration_words(double seconds);

}  // namespace impetus::inline commands
