// What somebody typed: keys by the names that pages give them ("1" to "9", "space", "enter",
// "escape", letters), and numbers.
// SPDX-License-Identifier: MIT
#pragma once

#include <SDL.h>

#include <optional>
#include <string>

#include "experiments/languages/language.hpp"

namespace impetus::inline window {

/// Whether this key goes by that name. Digits count on the keypad too, and by their place on the
/// keyboard, since some layouts want Shift for them.
[[nodiscard]] bool is_key(const SDL_Keysym& pressed, const std::string& name);

/// "Enter" for "enter", as it is printed on a button in this language.
[[nodiscard]] std::string printed_key(const std::string& name, const Language& language);

/// The number that the text is, with a point for decimals; nothing when it is anything else.
std::optional<double> typed_number(const std::string& text);

}  // namespace impetus::inline window
