// The window sends input to itself while it shows pictures, and notes when each arrives.
//
//   into the queue           as if SDL had just taken it from the system
//   into the window system   by X11's test extension, as a device's driver does
//
// A key or a movement is sent from a thread of its own, at instants that wander through the frame.
// One is on its way at a time: the next is sent when it has arrived, or is given up.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "experiments/record/sent_input.hpp"
#include "experiments/window/window.hpp"

namespace impetus::inline window {

/// Calls `show`, which shows a picture in the window, until it returns false. Arrivals have the
/// stamps and uncertainties that a session would keep. Somebody's own hand on the mouse disturbs
/// the test. `clock` is the window's.
InputTrace try_input(Window& window, const Clock& clock, const std::function<bool()>& show);

/// Puts the pointer into the window's middle.
void centre_pointer(Window& window);

}  // namespace impetus::inline window
