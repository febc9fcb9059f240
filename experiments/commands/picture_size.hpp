// How large a picture is that goes to a file: what was asked for, or as the screen's sides have it.
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/scheduling/viewer.hpp"
#include "experiments/window/pixels.hpp"

namespace impetus::inline commands {

/// A side in pixels, `usual` where it was not asked for, which is 0. Throws InputError, naming the
/// option.
int picture_px(const char* option, int asked, int usual);

/// Of the options --width and --height for a picture of the whole screen. A width that was not
/// asked for is the screen's own, or 1280 where the screen's pixels are not known; a height follows
/// from the width, as the screen's sides have it, and is even, as most kinds of films need it,
/// unless it is the screen's own.
PictureSize picture_size(int width_px, int height_px, const ScreenGeometry& screen);

}  // namespace impetus::inline commands
