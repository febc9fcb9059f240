// What somebody may have meant who mistyped a word.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace impetus::inline commands {

/// Of `words` the one that takes the fewest letters added, left out or changed to become `given`,
/// the first of equals; empty when that is more than two, or half of the word. (Levenshtein 1966)
[[nodiscard]] std::string nearest_word(const std::string& given,
                                       const std::vector<std::string>& words);

}  // namespace impetus::inline commands
