// SPDX-License-Identifier: MIT
#include "experiments/window/typed_number.hpp"

#include <charconv>
#include <cmath>

namespace impetus::inline window {

std::optional<double> typed_number(const std::string& text) {
  double value = 0.0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  const bool whole = error == std::errc() && stop == end && std::isfinite(value);
  return whole ? std::optional(value) : std::nullopt;
}

}  // namespace impetus::inline window
