// SPDX-License-Identifier: MIT
#include "experiments/viewing/finest_beside.hpp"

namespace impetus::inline viewing {

bool FinestBeside::go_on() {
  constexpr std::int64_t kPartOfFrame_ns = 10'000'000;
  if (view_) {
    return false;
  }
  if (!running_) {
    running_ = std::make_unique<ReplaySimulation>(scene_, steps_, SimulatedDetail::kFinest);
  }
  const std::int64_t began_ns = clock_.now_ns();
  while (!running_->done() && clock_.now_ns() - began_ns < kPartOfFrame_ns) {
    running_->advance();
  }
  if (!running_->done()) {
    return false;
  }
  view_ = running_->take();
  running_.reset();
  return true;
}

double FinestBeside::share() const { return view_ ? 1.0 : running_ ? running_->share() : 0.0; }

}  // namespace impetus::inline viewing
