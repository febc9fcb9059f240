// SPDX-License-Identifier: MIT
#include "experiments/commands/progress_line.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <utility>

namespace impetus {

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
  if (percent <= told_percent_ || (!terminal_ && now - told_at_ < kSparse)) {
    return;
  }
  told_percent_ = percent;
  told_at_ = now;
  if (terminal_) {
    std::fprintf(stderr, "\r%s %d %%", what_.c_str(), percent);
  } else {
    std::fprintf(stderr, "%s %d %%\n", what_.c_str(), percent);
  }
  std::fflush(stderr);
}

}  // namespace impetus
