// Lines of Hebrew and Arabic as they stand on the screen: from left to right, Arabic letters in the
// forms that they have beside their neighbours, for fonts that hold such forms as letters.
//
//   a paragraph, as it is read ─lines_of─> lines, as read ─visual_line─> lines, as drawn
//
// Order after Unicode's bidirectional algorithm (UAX 9), by FriBidi.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace impetus::inline window {

/// Whether a text is read from right to left: as its first letter is, or `without` where it has
/// none.
bool is_right_to_left(std::string_view text, bool without = false);

/// Whether any letter of it is.
bool has_right_to_left(std::string_view text);

/// One line of a text that is read from the right, or not, as it is drawn. The line itself where
/// nothing in it is read from right to left.
std::string visual_line(std::string_view line, bool from_right);

/// A label, which is a text of one line.
std::string visual_label(std::string_view label);

}  // namespace impetus::inline window
