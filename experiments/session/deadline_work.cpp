// SPDX-License-Identifier: MIT
#include "experiments/session/deadline_work.hpp"

#include <algorithm>

namespace impetus {
namespace {

/// Node-pair tests between two looks at the clock: a microsecond or two of work, so that looking
/// costs little beside it, and a deadline is missed by no more.
constexpr std::int64_t kSliceTests = 64;

}  // namespace

void DeadlineWork::start_step() {
  deadline_ns_ = clock_->now_ns() + ns_per_step_;
  granted_ = 0;
  slice_end_ = 0;
  refused_ = false;
}

std::int64_t DeadlineWork::request(std::int64_t total_tests) {
  if (total_tests > slice_end_ && !refused_) {
    refused_ = clock_->now_ns() >= deadline_ns_;
    slice_end_ = refused_ ? granted_ : total_tests + kSliceTests;
  }
  if (total_tests <= slice_end_) {
    granted_ = std::max(granted_, total_tests);
  }
  return granted_;
}

}  // namespace impetus
