// SPDX-License-Identifier: MIT
#include "experiments/observers/headless_lab.hpp"

namespace impetus::inline observers {

Flip HeadlessDisplay::show(const Picture& picture) {
  static_cast<void>(picture);
  const std::int64_t submitted_ns = clock_->now_ns();
  clock_->advance_to(grid_.next_due_ns());
  return grid_.flipped(submitted_ns, clock_->now_ns());
}

}  // namespace impetus::inline observers
