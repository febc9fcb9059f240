// A user's file, argument or machine that cannot be used: one sentence, refused before anything
// is shown or written.
// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>

namespace impetus::inline settings {

/// The message names file, place, what was expected and what was there.
class InputError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace impetus::inline settings
