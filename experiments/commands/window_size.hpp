// How large what is painted is: the option --window WIDTHxHEIGHT and the pixels of such a window,
// and the options --width and --height of a picture that goes to a file.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "engine/scheduling/viewer.hpp"
#include "experiments/window/display.hpp"
#include "experiments/window/pixels.hpp"
#include "experiments/window/window.hpp"

namespace impetus::inline commands {

/// Fullscreen for "". Throws InputError for anything but WIDTHxHEIGHT of at least 640x480.
WindowOptions window_options(const std::string& size);

/// The display as such a window will show it, found without opening the window. Throws
/// std::runtime_error when there is no display.
DisplayMode shown_mode(const WindowOptions& window);

/// A side in pixels, `usual` where it was not asked for, which is 0. Throws InputError, naming the
/// option.
int picture_px(const char* option, int asked, int usual);

/// Of the options --width and --height for a picture of the whole screen. What was not asked for,
/// 0, is the screen's own, or 1280 across where its pixels are not known, or follows from the other
/// side: then it is even, as most kinds of films need it. Throws InputError for another shape than
/// the screen's.
PictureSize picture_size(int width_px, int height_px, const ScreenGeometry& screen);

/// Refuses --width and --height, where given, of a command that writes no picture; `pictures` says
/// which options would. Throws InputError.
void require_picture_of_size(int width_px, int height_px, const std::string& pictures);

}  // namespace impetus::inline commands
