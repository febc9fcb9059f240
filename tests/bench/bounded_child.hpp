// Work in a child process with a time of its own: what hangs or crashes there spoils nothing here.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

namespace impetus {

enum class ChildEnd {
  kDone,     ///< and said what it found
  kRefused,  ///< threw an exception
  kHung,     ///< used up its time
  kCrashed,  ///< was ended by a signal, or ended itself
};

struct ChildResult {
  ChildEnd end{ChildEnd::kCrashed};
  std::vector<double> found{};  ///< when it is done
};

/// Runs `work` in a child, silently, for at most `most_cpu_s` of CPU time (whole seconds).
ChildResult in_bounded_child(const std::function<std::vector<double>()>& work, int most_cpu_s);

}  // namespace impetus
