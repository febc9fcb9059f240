// A user's file, argument or machine that cannot be used: one sentence, refused before anything
// is shown or written.
// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace impetus::inline settings {

/// The message names file, place, what was expected and what was there.
class InputError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// "one, two, three": what was expected.
inline std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) {
    text += (text.empty() ? "" : ", ") + name;
  }
  return text;
}

}  // namespace impetus::inline settings
