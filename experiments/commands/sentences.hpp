// How commands refuse what they were given: one sentence, thrown.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "experiments/settings/input_error.hpp"

namespace impetus::inline commands {

/// Throws InputError with the sentence unless it is fulfilled.
inline void require(bool fulfilled, const std::string& sentence) {
  if (!fulfilled) {
    throw InputError(sentence);
  }
}

}  // namespace impetus::inline commands
