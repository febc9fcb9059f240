// Who does several things of a step at once, lent to a world by whoever steps it. What a step
// finds, and what it counts, does not depend on how many there are.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

namespace impetus::inline scheduling {

/// Several workers of which one is who asks. The engine starts no thread: a pool
/// of threads, or whatever the program has for that, does.
class Workers {
 public:
  virtual ~Workers() = default;

  /// At least 1; always the same.
  [[nodiscard]] virtual int count() const = 0;

  /// Calls `job` with every number from 0 to count() - 1, at the same time as far as it can;
  /// returns when all have returned. Throws what one of them threw. One caller at a time.
  virtual void run(const std::function<void(int worker)>& job) = 0;
};

}  // namespace impetus::inline scheduling
