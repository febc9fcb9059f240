// A text as the lines that fit a width.
// SPDX-License-Identifier: MIT
#pragma once

#include <imgui.h>

#include <string>
#include <string_view>
#include <vector>

namespace impetus::inline window {

/// From the top of one line to the top of the next, in pixels.
float line_height(const ImFont& font);

/// The lines, broken between words, or within one that is longer than a line. They look into
/// `text`, which must outlive them.
std::vector<std::string_view> lines_of(const std::string& text, const ImFont& font, float width_px);

/// The width of a text on one line, in pixels.
float width_of(std::string_view text, const ImFont& font);

}  // namespace impetus::inline window
