// SDL's video, opened only where somebody can see it.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace impetus::inline window {

/// Opens it once more; every call needs its SDL_QuitSubSystem(SDL_INIT_VIDEO). Throws
/// std::runtime_error with one sentence when there is no display.
void open_video();

/// The same without anybody to see it: with the display where there is one, without it elsewhere.
void open_unseen_video();

/// Throws the sentence that says so.
[[noreturn]] void refuse_display(const std::string& why);

}  // namespace impetus::inline window
