// Shaders compiled and linked.
// SPDX-License-Identifier: MIT
#pragma once

#include <initializer_list>

namespace impetus::inline drawing {

/// A program from the texts of its two shaders, each given in parts; the caller owns it. Needs a
/// current context. Throws std::runtime_error with the driver's words when it refuses.
unsigned link_program(std::initializer_list<const char*> vertex,
                      std::initializer_list<const char*> fragment);

}  // namespace impetus::inline drawing
