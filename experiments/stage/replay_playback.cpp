// SPDX-License-Identifier: MIT
#include "experiments/stage/replay_playback.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/dynamics/motion.hpp"

namespace impetus {
namespace {

struct Speed {
  double factor;
  const char* name;
};
constexpr std::array<Speed, 4> kSpeeds{{{1.0, "1"}, {0.5, "½"}, {0.25, "¼"}, {0.1, "1/10"}}};

/// A time that was set by step k may come back a hair below k.
constexpr double kOfAStep = 1e-6;

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
  time_s_ = std::min(span_s_, time_s_ + real_s * kSpeeds[speed_].factor);
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
  const double target =
      direction > 0 ? std::floor(steps + kOfAStep) + 1.0 : std::ceil(steps - kOfAStep) - 1.0;
  seek(target / replay_.step_hz);
}

void ReplayPlayback::change_speed(int direction) {
  const auto slowest = static_cast<int>(kSpeeds.size()) - 1;
  speed_ = static_cast<std::size_t>(std::clamp(static_cast<int>(speed_) - direction, 0, slowest));
}

void ReplayPlayback::seek(double time_s) {
  playing_ = false;
  time_s_ = std::clamp(time_s, 0.0, span_s_);
}

std::int64_t ReplayPlayback::step_number() const {
  const auto steps = static_cast<std::int64_t>(std::floor(time_s_ * replay_.step_hz + kOfAStep));
  return std::min(steps, last_step());
}

std::int64_t ReplayPlayback::last_step() const {
  return static_cast<std::int64_t>(replay_.states.size()) - 1;
}

std::string ReplayPlayback::speed() const { return kSpeeds[speed_].name; }

std::vector<BodyDetail> ReplayPlayback::details() const {
  const auto step = static_cast<std::size_t>(step_number());
  return step < replay_.details.size() ? replay_.details[step]
                                       : std::vector<BodyDetail>(replay_.looks.size());
}

std::vector<PosedBody> ReplayPlayback::bodies() const {
  const auto before = static_cast<std::size_t>(step_number());
  const std::size_t after = std::min(before + 1, replay_.states.size() - 1);
  const double fraction =
      std::clamp(time_s_ * replay_.step_hz - static_cast<double>(before), 0.0, 1.0);
  std::vector<PosedBody> bodies;
  for (std::size_t body = 0; body < replay_.looks.size(); ++body) {
    const BodyState& here = replay_.states[before][body];
    const Pose pose =
        after > before ? between(here, replay_.states[after][body], fraction) : here.pose;
    bodies.push_back({pose, replay_.looks[body]});
  }
  return bodies;
}

}  // namespace impetus
