// Tells of trees that are built while a command reads and checks what it was given.
// SPDX-License-Identifier: MIT
#pragma once

#include <mutex>

#include "experiments/commands/progress_line.hpp"
#include "experiments/models/tree_cache.hpp"

namespace impetus::inline commands {

/// For as long as it lives; where something else tells of a tree, it is silent.
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
