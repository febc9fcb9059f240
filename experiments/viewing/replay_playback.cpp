// SPDX-License-Identifier: MIT
#include "experiments/viewing/replay_playback.hpp"

#include <algorithm>
#include <cmath>

namespace impetus::inline viewing {
namespace {

constexpr int kSlowest = -4;
constexpr int kFastest = 2;

}  // namespace

ReplayPlayback::ReplayPlayback(const ReplayView& replay)
    : replay_(replay),
      span_s_(std::max(replay.duration_s,
                       static_cast<double>(replay.states.size() - 1) / replay.step_hz)) {
  for (const TimelineMark& mark : replay.marks) {
    span_s_ = std::max({span_s_, mark.begin_s, mark.end_s});
  }
}

void ReplayPlayback::advance(double real_s) {
  if (!playing_) {
    return;
  }
  time_s_ = std::min(span_s_, time_s_ + std::ldexp(real_s, speed_));
  playing_ = time_s_ < span_s_;
}

void ReplayPlayback::toggle() {
  if (!playing_ && time_s_ >= span_s_) {
    time_s_ = 0.0;
  }
  playing_ = !playing_;
}

void ReplayPlayback::step(int direction) {
  const double steps = time_s_ * replay_.step_hz;
  const double target = direction > 0 ? std::floor(steps + kStepRounding) + 1.0
                                      : std::ceil(steps - kStepRounding) - 1.0;
  seek(target / replay_.step_hz);
}

void ReplayPlayback::change_speed(int direction) {
  speed_ = std::clamp(speed_ + direction, kSlowest, kFastest);
}

void ReplayPlayback::seek(double time_s) {
  playing_ = false;
  time_s_ = std::clamp(time_s, 0.0, span_s_);
}

std::int64_t ReplayPlayback::last_step() const {
  return static_cast<std::int64_t>(replay_.states.size()) - 1;
}

std::string ReplayPlayback::speed_words() const {
  return speed_ < 0 ? "×1/" + std::to_string(1 << -speed_) : "×" + std::to_string(1 << speed_);
}

}  // namespace impetus::inline viewing
