// SPDX-License-Identifier: MIT
#include "experiments/viewing/replay_playback.hpp"

#include <algorithm>
#include <cmath>

namespace impetus::inline viewing {
namespace {

constexpr int kSlowest = -4;
constexpr int kFastest = 2;

bool is_target(TimelineMark::Kind kind, JumpTarget target) {
  using Kind = TimelineMark::Kind;
  switch (target) {
    case JumpTarget::kCollision:
      return kind == Kind::kFineCollision || kind == Kind::kCoarseCollision;
    case JumpTarget::kClick:
      return kind == Kind::kClick;
    case JumpTarget::kLateFrame:
      return kind == Kind::kLateFrame;
    case JumpTarget::kResponse:
      return kind == Kind::kResponse;
  }
  return false;
}

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

const char* word_of(JumpTarget target) {
  return target == JumpTarget::kCollision   ? "collision"
         : target == JumpTarget::kClick     ? "click"
         : target == JumpTarget::kLateFrame ? "late frame"
                                            : "answer";
}

bool has_target(const std::vector<TimelineMark>& marks, JumpTarget target) {
  return std::any_of(marks.begin(), marks.end(),
                     [target](const TimelineMark& mark) { return is_target(mark.kind, target); });
}

std::optional<double> jump_from(const std::vector<TimelineMark>& marks, JumpTarget target,
                                double time_s, int direction, double step_hz) {
  const double apart_s = 0.5 / step_hz;
  std::optional<double> nearest_s;
  for (const TimelineMark& mark : marks) {
    const double ahead_s = direction * (mark.begin_s - time_s);
    const bool nearer = !nearest_s || ahead_s < direction * (*nearest_s - time_s);
    if (is_target(mark.kind, target) && ahead_s > apart_s && nearer) {
      nearest_s = mark.begin_s;
    }
  }
  return nearest_s;
}

}  // namespace impetus::inline viewing
