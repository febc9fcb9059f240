// SPDX-License-Identifier: MIT
#include "experiments/window/typed_input.hpp"

#include <cctype>
#include <charconv>
#include <cmath>

namespace impetus::inline window {
namespace {

bool is_digit(const SDL_Keysym& pressed, char digit) {
  const int place = digit == '0' ? 9 : digit - '1';  // the row runs 1 2 … 9 0
  return pressed.sym == digit || pressed.scancode == SDL_SCANCODE_1 + place ||
         pressed.scancode == SDL_SCANCODE_KP_1 + place;
}

/// A keyboard for letters that are not Latin: keys go by the Latin letters that stand beside them.
bool writes_another_script(const SDL_Keysym& pressed) {
  constexpr SDL_Keycode kFirst = 0x0370;  // Greek
  return pressed.sym >= kFirst && (pressed.sym & SDLK_SCANCODE_MASK) == 0;
}

}  // namespace

bool is_key(const SDL_Keysym& pressed, const std::string& name) {
  if (name.size() == 1 && std::isdigit(static_cast<unsigned char>(name[0])) != 0) {
    return is_digit(pressed, name[0]);
  }
  if (name == "enter") {
    return pressed.sym == SDLK_RETURN || pressed.sym == SDLK_KP_ENTER;
  }
  if (name.empty() || SDL_GetKeyFromName(name.c_str()) == SDLK_UNKNOWN) {
    return false;
  }
  return writes_another_script(pressed) ? pressed.scancode == SDL_GetScancodeFromName(name.c_str())
                                        : pressed.sym == SDL_GetKeyFromName(name.c_str());
}

std::string printed_key(const std::string& name, const Language& language) {
  if (name == "escape") {
    return language.text("escape");
  }
  if (name == "space") {
    return language.text("space_bar");
  }
  if (name == "enter") {
    return language.text("enter");
  }
  std::string printed = name;
  if (!printed.empty()) {
    printed[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(printed[0])));
  }
  return printed;
}

std::optional<double> typed_number(const std::string& text) {
  double value = 0.0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  const bool whole = error == std::errc() && stop == end && std::isfinite(value);
  return whole ? std::optional(value) : std::nullopt;
}

}  // namespace impetus::inline window
