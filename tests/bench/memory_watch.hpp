// The resident memory of this program, looked at once a second from a thread of its own.
// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <thread>
#include <vector>

namespace impetus {

struct MemoryGrowth {
  double first_MiB{0.0};  ///< at the end of what is left out
  double last_MiB{0.0};
  double slope_kiB_per_min{0.0};  ///< least squares, from there on
};

class MemoryWatch {
 public:
  /// Begins to look.
  MemoryWatch();
  ~MemoryWatch();
  MemoryWatch(const MemoryWatch&) = delete;
  MemoryWatch& operator=(const MemoryWatch&) = delete;

  /// Stops, and leaves out the first `left_out_s` seconds, in which everything is still filled.
  MemoryGrowth stop(double left_out_s);

 private:
  std::atomic<bool> stopping_{false};
  std::vector<double> kiB_;  ///< one a second; the thread's until it is joined
  std::thread thread_;
};

}  // namespace impetus
