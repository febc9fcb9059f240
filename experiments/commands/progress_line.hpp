// How far a piece of work has come and how long the rest will take, on standard error: one line
// that changes on a terminal, a line every two seconds elsewhere.
//
//   building the bodies 12 %, about 3 min left
//
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <mutex>
#include <string>

#include "experiments/models/tree_cache.hpp"

namespace impetus::inline commands {

/// "0.4 s", "50 s", "12 min", "3 h 20 min", "2 days 5 h"; `seconds` ≥ 0.
std::string duration_words(double seconds);

/// Tells how far a piece of work has come, for as long as it lives.
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

/// Tells of trees that are built while a command reads and checks what it was given, for as long as
/// it lives; where something else tells of a tree, it is silent.
class BuildingLine {
 private:
  std::mutex mutex_;  ///< trees may be built by several threads
  ProgressLine line_{"building a tree"};
  BuildingWatch watch_{[this](double share) {
    const std::lock_guard lock(mutex_);
    line_.tell(share);
  }};
};

}  // namespace impetus::inline commands
