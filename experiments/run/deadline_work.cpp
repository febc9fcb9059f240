// SPDX-License-Identifier: MIT
#include "experiments/run/deadline_work.hpp"

#include <algorithm>

namespace impetus::inline run {
namespace {

/// Units of work between two looks at the clock: a microsecond or so of work. Where time is short
/// a deadline is missed by no more than the fewest take; where it is not, the most keep looking,
/// which can take as long as a hundred units, cheap beside the work.
constexpr double kFewestUnits = 64.0;
constexpr double kMostUnits = 512.0;

/// Of the units that still fit before the deadline.
constexpr double kShareOfSlice = 0.125;

/// How slow a step is, is told by as many of its first units, which are of coarse nodes and as cold
/// as what follows detection; fewer say little, since the looks at the clock count in.
constexpr std::int64_t kTellingUnits = 1'000;

/// What those take, the looks included, where later phases take kLeastNsPerUnit: 30 to 55 ns in
/// crowds, less among few bodies.
constexpr double kUsualNsPerUnit = 40.0;

}  // namespace

void DeadlineWork::start_step() {
  deadline_ns_ = clock_->now_ns() + ns_per_step_;
  granted_ = 0;
  slice_end_ = 0;
  refused_ = false;
  first_done_ = -1;
  ns_per_unit_ = 0.0;
}

std::int64_t DeadlineWork::request(std::int64_t total, std::int64_t reserved) {
  if (total > slice_end_ && !refused_) {
    const double fitting = fitting_units(clock_->now_ns(), total - reserved, reserved);
    const double slice = std::clamp(kShareOfSlice * fitting, kFewestUnits, kMostUnits);
    refused_ = fitting <= 0.0;
    slice_end_ = refused_ ? granted_ : total + static_cast<std::int64_t>(slice);
  }
  if (total <= slice_end_) {
    granted_ = std::max(granted_, total);
  }
  return granted_;
}

double DeadlineWork::fitting_units(std::int64_t now_ns, std::int64_t done, std::int64_t reserved) {
  if (first_done_ < 0) {
    first_done_ = done;
    first_ns_ = now_ns;
  }
  if (ns_per_unit_ == 0.0 && done - first_done_ >= kTellingUnits) {
    const double measured_ns =
        static_cast<double>(now_ns - first_ns_) / static_cast<double>(done - first_done_);
    ns_per_unit_ = kLeastNsPerUnit * std::max(1.0, measured_ns / kUsualNsPerUnit);
  }
  const double later_ns_per_unit = std::max(kLeastNsPerUnit, ns_per_unit_);
  return static_cast<double>(deadline_ns_ - now_ns) / later_ns_per_unit -
         static_cast<double>(reserved);
}

}  // namespace impetus::inline run
