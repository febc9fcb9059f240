// SPDX-License-Identifier: MIT
#include "experiments/session/deadline_work.hpp"

#include <algorithm>

namespace impetus {
namespace {

/// Units of work between two looks at the clock: a microsecond or two of work, so that looking
/// costs little beside it, and a deadline is missed by no more.
constexpr std::int64_t kSliceUnits = 64;

/// Modelling and response touch memory that detection did not: how much slower they may be.
constexpr double kSafety = 1.5;

}  // namespace

void DeadlineWork::start_step() {
  deadline_ns_ = clock_->now_ns() + ns_per_step_;
  granted_ = 0;
  slice_end_ = 0;
  refused_ = false;
  first_done_ = -1;
}

std::int64_t DeadlineWork::request(std::int64_t total, std::int64_t reserved) {
  if (total > slice_end_ && !refused_) {
    refused_ = too_late(clock_->now_ns(), total - reserved, reserved);
    slice_end_ = refused_ ? granted_ : total + kSliceUnits;
  }
  if (total <= slice_end_) {
    granted_ = std::max(granted_, total);
  }
  return granted_;
}

bool DeadlineWork::too_late(std::int64_t now_ns, std::int64_t done, std::int64_t reserved) {
  if (first_done_ < 0) {
    first_done_ = done;
    first_ns_ = now_ns;
  }
  double ns_per_unit = kLeastNsPerUnit;
  if (done > first_done_) {
    const double measured_ns =
        static_cast<double>(now_ns - first_ns_) / static_cast<double>(done - first_done_);
    ns_per_unit = std::max(ns_per_unit, kSafety * measured_ns);
  }
  const double left_ns = static_cast<double>(deadline_ns_ - now_ns);
  return left_ns <= ns_per_unit * static_cast<double>(reserved);
}

}  // namespace impetus
