// SPDX-License-Identifier: MIT
#include "experiments/record/frame_grid.hpp"

#include <algorithm>

namespace impetus::inline record {

std::int64_t FrameGrid::due_ns(std::int64_t slot) const {
  return anchor_ns_ + std::llround(static_cast<double>(slot) * period_ns_);
}

Flip FrameGrid::flipped(std::int64_t submitted_ns, std::int64_t flipped_ns) {
  Flip flip{next_due_ns(), submitted_ns, flipped_ns, 0};
  const double slots_late = static_cast<double>(flip.lateness_ns()) / period_ns_;
  flip.missed_slots = std::max<std::int64_t>(0, std::llround(slots_late));
  slot_ += 1 + flip.missed_slots;
  return flip;
}

}  // namespace impetus::inline record
