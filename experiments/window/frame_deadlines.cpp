// SPDX-License-Identifier: MIT
#include "experiments/window/frame_deadlines.hpp"

#include <epoxy/gl.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>
#include <vector>

namespace impetus::inline window {
namespace {

constexpr std::int64_t kBetweenPumpsNs = 500'000;
constexpr std::int64_t kSwapAheadNs = 3'000'000;

}  // namespace

FrameDeadlines::FrameDeadlines(GlWindow& window, EventPump& events, const Clock& clock)
    : window_(window), events_(events), clock_(clock), grid_(window.refresh_hz()) {
  window_.wait_for_refresh(false);
  grid_.restart(clock_.now_ns());
}

void FrameDeadlines::restart() {
  const std::int64_t now_ns = clock_.now_ns();
  const double slots = static_cast<double>(now_ns - last_flip_ns_) / grid_.period_ns();
  const bool recent = slots < 1.0;
  if (last_flip_ns_ == 0 || (!recent && !swap_blocks_)) {
    grid_.restart(now_ns);
  } else {
    grid_.restart(last_flip_ns_ + std::llround(std::floor(slots) * grid_.period_ns()));
  }
}

Flip FrameDeadlines::flip() {
  glFlush();  // drawing goes on while we wait
  wait_until(grid_.next_due_ns() - (swap_blocks_ ? kSwapAheadNs : 0));
  const std::int64_t submitted_ns = clock_.now_ns();
  window_.swap();
  last_flip_ns_ = clock_.now_ns();
  events_.pump();
  return grid_.flipped(submitted_ns, last_flip_ns_);
}

void FrameDeadlines::wait_until(std::int64_t due_ns) {
  events_.pump();
  for (std::int64_t left_ns = due_ns - clock_.now_ns(); left_ns > 0;
       left_ns = due_ns - clock_.now_ns()) {
    std::this_thread::sleep_for(std::chrono::nanoseconds(std::min(left_ns, kBetweenPumpsNs)));
    events_.pump();
  }
}

SyncTest FrameDeadlines::sync_test(const std::function<void()>& draw) {
  const bool can_wait = window_.wait_for_refresh(true);
  const auto flips = [&](int count) {
    std::vector<std::int64_t> stamps;
    for (int i = 0; i < count && !events_.closed(); ++i) {
      draw();
      window_.swap();
      stamps.push_back(clock_.now_ns());
      events_.pump();
    }
    return stamps;
  };
  SyncTest test = run_sync_test(flips, window_.refresh_hz());
  swap_blocks_ = can_wait && test.passed;
  window_.wait_for_refresh(swap_blocks_);
  // On the nominal rate a grid of blocking swaps would slide off by up to 1 %: it takes its own.
  grid_ = FrameGrid(swap_blocks_ ? 1e9 / test.mean_interval_ns : window_.refresh_hz());
  last_flip_ns_ = clock_.now_ns();
  restart();
  return test;
}

std::string FrameDeadlines::anchor() const {
  return swap_blocks_ ? "return of a swap that waits for the refresh" : "timer, no synchronisation";
}

}  // namespace impetus::inline window
