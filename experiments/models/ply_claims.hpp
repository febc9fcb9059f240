// What a PLY file claims to hold, beside what it holds.
//
//   header: elements, each so many times, with these properties ... end_header
//   body:   the elements one after another; a list is its length, then so many values
//
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace impetus::inline models {

/// What cannot be so, or never ends, in words; "" when nothing. Precondition: begins with "ply".
std::string ply_problem(std::string_view bytes);

}  // namespace impetus::inline models
