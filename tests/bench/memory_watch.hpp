// The memory of this program, looked at once a second from a thread of its own.
//
// A trial's record grows while the trial runs and is given back when it is written: what is left
// over is seen where memory is least. So each minute counts by its least value.
// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <thread>
#include <vector>

namespace impetus {

/// The least of each minute.
struct MemoryGrowth {
  double first_MiB{0.0};  ///< of the first minute that counts
  double last_MiB{0.0};
  double slope_kiB_per_min{0.0};  ///< least squares
};

struct MemoryUse {
  MemoryGrowth resident;   ///< with what the allocator keeps, libraries, the driver's pictures
  MemoryGrowth allocated;  ///< what malloc and new have given and not got back
  double most_resident_MiB{0.0};
};

class MemoryWatch {
 public:
  /// Begins to look.
  MemoryWatch();
  ~MemoryWatch();
  MemoryWatch(const MemoryWatch&) = delete;
  MemoryWatch& operator=(const MemoryWatch&) = delete;

  /// Stops, and leaves out the first `left_out_s` seconds, in which everything is still filled.
  MemoryUse stop(double left_out_s);

 private:
  std::atomic<bool> stopping_{false};
  std::vector<double> resident_kiB_;  ///< one a second; the thread's until it is joined
  std::vector<double> allocated_kiB_;
  std::thread thread_;
};

}  // namespace impetus
