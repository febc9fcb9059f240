// The screen that a command without a session looks at.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "engine/scheduling/viewer.hpp"

namespace impetus {

/// Of the screen file, or the user's own when `file` is "". Where none was entered one is assumed,
/// and that is said. Its pixels are 0: the window's, if there is one. Throws InputError.
ScreenGeometry chosen_screen(const std::string& file);

}  // namespace impetus
