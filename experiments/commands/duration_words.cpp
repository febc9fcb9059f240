// SPDX-License-Identifier: MIT
#include "experiments/commands/duration_words.hpp"

#include <cmath>
#include <cstdio>

namespace impetus::inline commands {
namespace {

std::string counted(long count, const char* unit) { return std::to_string(count) + " " + unit; }

}  // namespace

std::string duration_words(double seconds) {
  if (seconds < 9.95) {
    char text[16];
    std::snprintf(text, sizeof text, "%.1f s", seconds);
    return text;
  }
  if (std::lround(seconds) < 120) {
    return counted(std::lround(seconds), "s");
  }
  const long minutes = std::lround(seconds / 60.0);
  if (minutes < 120) {
    return counted(minutes, "min");
  }
  const long hours = std::lround(seconds / 3600.0);
  if (hours < 48) {
    return counted(minutes / 60, "h") +
           (minutes % 60 > 0 ? " " + counted(minutes % 60, "min") : "");
  }
  return counted(hours / 24, "days") + (hours % 24 > 0 ? " " + counted(hours % 24, "h") : "");
}

}  // namespace impetus::inline commands
