// SPDX-License-Identifier: MIT
#include "engine/collision/swept_intervals.hpp"

#include <algorithm>
#include <limits>

namespace impetus::inline collision {
namespace {

using Ends = SweptIntervals::Ends;

IMPETUS_INLINED std::uint32_t meeting_by_lanes(const Ends& one, const Ends& others) {
  const double greatest = one.greatest[0];
  const double least_across[2] = {one.across_least[0][0], one.across_least[1][0]};
  const double greatest_across[2] = {one.across_greatest[0][0], one.across_greatest[1][0]};
  std::uint64_t meets[kLanes];
  for (int lane = 0; lane < kLanes; ++lane) {
    const bool along = others.least[lane] <= greatest;
    const bool second = (others.across_least[0][lane] <= greatest_across[0]) &
                        (least_across[0] <= others.across_greatest[0][lane]);
    const bool third = (others.across_least[1][lane] <= greatest_across[1]) &
                       (least_across[1] <= others.across_greatest[1][lane]);
    meets[lane] = (along & second & third) ? std::uint64_t{1} << lane : 0;
  }
  std::uint64_t bits = 0;
  for (int lane = 0; lane < kLanes; ++lane) {
    bits |= meets[lane];
  }
  return static_cast<std::uint32_t>(bits);
}

#ifdef IMPETUS_EIGHT_LANES
IMPETUS_EIGHT_LANES std::uint32_t meeting_by_eight(const Ends& one, const Ends& others) {
  return meeting_by_lanes(one, others);
}

IMPETUS_FOUR_LANES std::uint32_t meeting_by_four(const Ends& one, const Ends& others) {
  return meeting_by_lanes(one, others);
}
#endif

}  // namespace

void SweptIntervals::take(const std::vector<SweptInterval>& sorted) {
  size_ = sorted.size();
  const std::size_t readable = size_ + kLanes - 1;
  for (std::vector<double>* ends : {&least_, &greatest_, &across_least_[0], &across_least_[1],
                                    &across_greatest_[0], &across_greatest_[1]}) {
    ends->resize(readable);
  }
  for (std::size_t i = 0; i < size_; ++i) {
    least_[i] = sorted[i].least;
    greatest_[i] = sorted[i].greatest;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      across_least_[axis][i] = sorted[i].across_least[axis];
      across_greatest_[axis][i] = sorted[i].across_greatest[axis];
    }
  }
  // Nothing reaches what is not there, not even what has no end.
  std::fill(least_.begin() + static_cast<std::ptrdiff_t>(size_), least_.end(),
            std::numeric_limits<double>::quiet_NaN());
}

SweptIntervals::Ends SweptIntervals::from(std::size_t index) const {
  return {&least_[index],
          &greatest_[index],
          {&across_least_[0][index], &across_least_[1][index]},
          {&across_greatest_[0][index], &across_greatest_[1][index]}};
}

std::uint32_t SweptIntervals::meeting(std::size_t index, std::size_t first, LaneWidth width) const {
  const Ends one = from(index);
  const Ends others = from(first);
#ifdef IMPETUS_EIGHT_LANES
  if (width == LaneWidth::kEight) {
    return meeting_by_eight(one, others);
  }
  if (width == LaneWidth::kFour) {
    return meeting_by_four(one, others);
  }
#endif
  return meeting_by_lanes(one, others);
}

}  // namespace impetus::inline collision
