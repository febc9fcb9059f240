// SPDX-License-Identifier: MIT
#include "experiments/window/key_names.hpp"

#include <cctype>

namespace impetus::inline window {
namespace {

bool is_digit(const SDL_Keysym& pressed, char digit) {
  const int place = digit == '0' ? 9 : digit - '1';  // the row runs 1 2 … 9 0
  return pressed.sym == digit || pressed.scancode == SDL_SCANCODE_1 + place ||
         pressed.scancode == SDL_SCANCODE_KP_1 + place;
}

}  // namespace

bool is_key(const SDL_Keysym& pressed, const std::string& name) {
  if (name.size() == 1 && std::isdigit(static_cast<unsigned char>(name[0])) != 0) {
    return is_digit(pressed, name[0]);
  }
  if (name == "enter") {
    return pressed.sym == SDLK_RETURN || pressed.sym == SDLK_KP_ENTER;
  }
  return !name.empty() && pressed.sym == SDL_GetKeyFromName(name.c_str()) &&
         pressed.sym != SDLK_UNKNOWN;
}

std::string printed_key(const std::string& name) {
  if (name == "escape") {
    return "Esc";
  }
  std::string printed = name;
  if (!printed.empty()) {
    printed[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(printed[0])));
  }
  return printed;
}

}  // namespace impetus::inline window
