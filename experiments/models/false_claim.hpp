// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>

namespace impetus::inline models {

/// What a mesh file claims of itself is false: the words are what().
class FalseClaim : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace impetus::inline models
