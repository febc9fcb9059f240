// A number as somebody typed it.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

namespace impetus::inline window {

/// The number that the text is, with a point for decimals; nothing when it is anything else.
std::optional<double> typed_number(const std::string& text);

}  // namespace impetus::inline window
