// A signed number of a body, a node or a step, as containers take it.
// SPDX-License-Identifier: MIT
#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>

namespace impetus::inline numerics {

/// Precondition: not negative.
inline std::size_t at(std::int32_t index) {
  assert(index >= 0);
  return static_cast<std::size_t>(index);
}

}  // namespace impetus::inline numerics
