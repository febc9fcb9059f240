// How commands refuse what they were given: one sentence, thrown.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "experiments/settings/input_error.hpp"

namespace impetus::inline commands {

/// Throws InputError with the sentence unless it is fulfilled.
inline void require(bool fulfilled, const std::string& sentence) {
  if (!fulfilled) {
    throw InputError(sentence);
  }
}

/// Throws InputError for the first of these options that was given, with what was expected beside
/// it.
inline void require_not_given(const std::vector<std::pair<bool, std::string>>& given,
                              const std::string& sentence) {
  for (const auto& [is_given, option] : given) {
    require(!is_given, option + ": " + sentence);
  }
}

}  // namespace impetus::inline commands
