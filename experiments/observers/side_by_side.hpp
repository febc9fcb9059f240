// Work in pieces that do not depend on each other, shared among threads.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>

namespace impetus::inline observers {

/// Does the pieces 0 … count − 1, as many at a time as there are cores, and throws what one threw.
void do_side_by_side(std::size_t count, const std::function<void(std::size_t)>& piece);

}  // namespace impetus::inline observers
