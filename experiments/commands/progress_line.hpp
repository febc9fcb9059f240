// How far a piece of work has come and how long the rest will take, on standard error: one line
// that changes on a terminal, a line every two seconds elsewhere.
//
//   building the bodies 12 %, about 3 min left
//
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <string>

namespace impetus::inline commands {

class ProgressLine {
 public:
  /// `what` is being done, such as "building".
  explicit ProgressLine(std::string what);
  /// Leaves a terminal's line empty.
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// `share` is done, from 0 to 1; at 0 another piece of the work begins.
  void tell(double share);

 private:
  std::string what_;
  bool terminal_;
  int told_percent_{-1};
  std::chrono::steady_clock::time_point began_at_{std::chrono::steady_clock::now()};
  std::chrono::steady_clock::time_point told_at_{began_at_};
};

}  // namespace impetus::inline commands
