// How a page is laid out: one column of comfortable width, its words, its choices, a small map of
// the screen, and along the bottom edge of every frame how far the session has come.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "experiments/record/page.hpp"
#include "experiments/window/gui.hpp"

namespace impetus::inline window {

/// Where a page's words stand.
struct Column {
  float left{0.0F};
  float width{0.0F};
};

/// 60 to 70 letters wide, in the middle of the window.
[[nodiscard]] Column reading_column(const Gui& gui);

/// Space between a page's parts.
[[nodiscard]] float part_gap();

/// Which choice stands out.
struct ChoiceMarks {
  std::optional<std::size_t> focused;
  std::optional<std::size_t> chosen;
};

/// Title and paragraphs, from the cursor down.
void draw_words(const Gui& gui, const Page& page, std::size_t reading_size);

/// The choices as buttons in rows, as the points of a scale with its anchors, or large, side by
/// side or, above `bottom_px` where that can be, one below the other. Returns the one that was
/// clicked.
std::optional<std::size_t> draw_choices(const Gui& gui, const Page& page, const ChoiceMarks& marks,
                                        float bottom_px);

/// The points that were looked at and where the gaze was, from the cursor down; nothing without
/// points.
void draw_point_map(const Gui& gui, const PointMap& map, const Language& language);

/// Height at the bottom that the bar and its label take.
[[nodiscard]] float progress_height(const Gui& gui);

/// What is under the bar: on pages its words are to be read, on pictures its colours must stay
/// quiet.
enum class BarPlace { kPage, kPicture };

/// Draws within the present frame; nothing when there is neither total nor label.
void draw_progress(const Gui& gui, const SessionProgress& progress, BarPlace place);

}  // namespace impetus::inline window
