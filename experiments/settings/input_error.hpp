// A user's file, argument or machine that cannot be used: one sentence, refused before anything
// is shown or written.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <stdexcept>
#include <string>

namespace impetus::inline settings {

/// The message names file, place, what was expected and what was there.
class InputError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// "one, two, three": what `name` makes of each.
template <typename Range, typename Name = std::identity>
std::string listed(const Range& range, const Name& name = {}) {
  std::string text;
  for (const auto& each : range) {
    text += (text.empty() ? "" : ", ") + std::string(std::invoke(name, each));
  }
  return text;
}

}  // namespace impetus::inline settings
