// SPDX-License-Identifier: MIT
#include "experiments/viewing/timeline_jumps.hpp"

#include <algorithm>

namespace impetus::inline viewing {

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
