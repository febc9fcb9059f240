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
  constexpr int kSparse = 25;
  const int percent = static_cast<int>(100.0 * std::clamp(share, 0.0, 1.0));
  const int step = terminal_ ? percent : percent / kSparse * kSparse;
  if (step <= told_percent_) {
    return;
  }
  told_percent_ = step;
  std::fprintf(stderr, terminal_ ? "\r%s %d %%" : "%s %d %%\n", what_.c_str(), step);
  std::fflush(stderr);
}

}  // namespace impetus
