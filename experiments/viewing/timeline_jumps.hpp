// From one mark of a replay's timeline to the next of its kind.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "experiments/viewing/replay_view.hpp"

namespace impetus::inline viewing {

/// What can be jumped to. Collisions are those of any level.
enum class JumpTarget { kCollision, kClick, kLateFrame, kResponse };

[[nodiscard]] bool is_target(TimelineMark::Kind kind, JumpTarget target);

/// "collision", "click", "late frame", "answer".
[[nodiscard]] const char* word_of(JumpTarget target);

[[nodiscard]] bool has_target(const std::vector<TimelineMark>& marks, JumpTarget target);

/// When the next (direction 1) or the last (−1) of them begins, more than half a step of `step_hz`
/// from `time_s`: marks of one moment are one jump. None: there is none that way.
[[nodiscard]] std::optional<double> jump_from(const std::vector<TimelineMark>& marks,
                                              JumpTarget target, double time_s, int direction,
                                              double step_hz);

}  // namespace impetus::inline viewing
