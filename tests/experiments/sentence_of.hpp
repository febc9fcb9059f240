// SPDX-License-Identifier: MIT
#pragma once

#include <exception>
#include <functional>
#include <string>

namespace impetus {

/// The sentence with which something is refused; "accepted" when it is not.
inline std::string sentence_of(const std::function<void()>& act) {
  try {
    act();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "accepted";
}

}  // namespace impetus
