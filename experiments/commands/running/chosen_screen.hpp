// The screen that a command without a session looks at.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "experiments/record/lab_screen.hpp"
#ifdef IMPETUS_WINDOW
#include "experiments/window/window.hpp"
#endif

namespace impetus::inline commands {

/// Of the screen file, or the user's own when `file` is "". Where none was entered one is assumed,
/// and that is said. Its pixels are 0. Throws InputError.
ScreenGeometry chosen_screen(const std::string& file);

#ifdef IMPETUS_WINDOW
/// The same for what such a window will show, whose pixels must be square unless the file says that
/// they are not. Its pixels are 0, too: the window's own, once it is open. Throws InputError, and
/// std::runtime_error when there is no display.
ScreenGeometry chosen_screen(const std::string& file, const WindowOptions& window);
#endif

/// What a simulated participant without a window looks at: the file's screen, 1024 pixels high, or
/// an assumed one where `file` is "". Throws InputError.
ScreenGeometry screen_without_window(const std::string& file);

/// The light of the same file's screen; none: there is none, or it was not measured.
std::optional<ScreenLight> chosen_light(const std::string& file);

}  // namespace impetus::inline commands
