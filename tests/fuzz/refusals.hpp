// What a reader may do with any bytes: take them, or refuse them in a sentence that names the file.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

#include "experiments/settings/input_error.hpp"

namespace impetus {

/// Ends the program unless `act` returns, or throws an InputError that begins with one of `names`.
inline void expect_taken_or_refused(const std::vector<std::string>& names,
                                    const std::function<void()>& act) {
  try {
    act();
  } catch (const InputError& error) {
    for (const std::string& name : names) {
      if (std::string(error.what()).starts_with(name)) {
        return;
      }
    }
    std::fprintf(stderr, "names no file: %s\n", error.what());
    std::abort();
  }
}

}  // namespace impetus
