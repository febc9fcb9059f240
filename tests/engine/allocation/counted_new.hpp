// What a program has taken with `new`: whoever links counted_new.cpp replaces it for the whole
// program.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace impetus {

struct Allocated {
  std::int64_t calls{0};  ///< of `new`, ever
  std::int64_t bytes{0};  ///< that are held now, as the C library rounds them
};

/// Since the program began.
Allocated allocated();

}  // namespace impetus
