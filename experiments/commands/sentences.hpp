// How commands refuse what they were given: one sentence, thrown.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "experiments/settings/input_error.hpp"

namespace impetus::inline commands {

/// Throws InputError with the sentence unless it is fulfilled.
inline void require(bool fulfilled, const std::string& sentence) {
  if (!fulfilled) {
    throw InputError(sentence);
  }
}

/// "one, two, three"
inline std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) {
    text += (text.empty() ? "" : ", ") + name;
  }
  return text;
}

}  // namespace impetus::inline commands
