// One page, from the flip that first shows it to its answer.
//
//   first flip ─> forget what was pressed before ─> events, frame, flip ─> ... ─> answer
//
// A press counts only when it was taken after the page was on the glass, so an impatient key
// cannot answer a question that has not been seen.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "experiments/record/ports.hpp"
#include "experiments/window/canvas.hpp"

namespace impetus::inline window {

/// Shows the page in the largest reading size at which it fits, until it is answered, paused, out
/// of time, or the window is closed; what does not fit even at the smallest size is scrolled.
Answer ask_page(Canvas& canvas, const Page& page);

/// Shows the page for this long; `choice` is drawn as chosen in the last third, if there is one.
void show_page_for(Canvas& canvas, const Page& page, double seconds,
                   std::optional<std::size_t> choice);

}  // namespace impetus::inline window
