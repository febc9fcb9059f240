// SPDX-License-Identifier: MIT
#include "experiments/commands/progress_line.hpp"

#include <unistd.h>
#include <cmath>

#include <algorithm>
#include <cstdio>
#include <utility>

#include "experiments/tables/number_text.hpp"

namespace impetus::inline commands {
namespace {

std::string counted(long count, const char* unit) { return std::to_string(count) + " " + unit; }

}  // namespace

std::string duration_words(double seconds) {
  if (seconds < 9.95) {
    return printed("%.1f s", seconds);
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

namespace {

/// ", about 3 min left", once enough is done to tell; "" of what is short.
std::string left_words(double share, std::chrono::duration<double> taken) {
  constexpr double kEnough_s = 1.0;
  constexpr double kShort_s = 5.0;
  const double left_s = share > 0.0 ? taken.count() * (1.0 - share) / share : 0.0;
  return taken.count() < kEnough_s || left_s < kShort_s
             ? ""
             : ", about " + duration_words(left_s) + " left";
}

}  // namespace

ProgressLine::ProgressLine(std::string what)
    : what_(std::move(what)), terminal_(isatty(STDERR_FILENO) != 0) {}

ProgressLine::~ProgressLine() {
  if (terminal_ && told_percent_ >= 0) {
    std::fprintf(stderr, "\r\033[K");
  }
}

void ProgressLine::tell(double share) {
  constexpr std::chrono::seconds kSparse{2};
  const int percent = static_cast<int>(100.0 * std::clamp(share, 0.0, 1.0));
  const auto now = std::chrono::steady_clock::now();
  if (share <= 0.0) {
    began_at_ = now;
    told_percent_ = -1;
  }
  if (percent <= told_percent_ || (!terminal_ && now - told_at_ < kSparse)) {
    return;
  }
  told_percent_ = percent;
  told_at_ = now;
  const std::string left = left_words(share, now - began_at_);
  std::fprintf(stderr, terminal_ ? "\r%s %d %%%s\033[K" : "%s %d %%%s\n", what_.c_str(), percent,
               left.c_str());
  std::fflush(stderr);
}

}  // namespace impetus::inline commands
