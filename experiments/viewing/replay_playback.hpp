// Where a replay stands: its time, its speed, how keys and flips move it, and from one mark of its
// timeline to the next.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "experiments/viewing/replay_view.hpp"

namespace impetus::inline viewing {

/// The time and the speed of one replay.
class ReplayPlayback {
 public:
  /// `replay` must outlive it and have at least one state. Starts playing at the onset.
  explicit ReplayPlayback(const ReplayView& replay);

  /// Moves on by `real_s` of real time when playing; stops at the end.
  void advance(double real_s);

  /// Plays on, from the start again when it stands at the end, or stands still.
  void toggle();
  /// Stands still, exactly on the next step (+1) or the one before (−1).
  void step(int direction);
  /// Slower (−1) or faster (+1), by halves and doubles, from 1/16 to 4.
  void change_speed(int direction);
  /// By this power of two.
  void set_speed(int power) { speed_ = power; }
  /// Stands still at this time.
  void seek(double time_s);

  [[nodiscard]] double time_s() const { return time_s_; }
  [[nodiscard]] bool playing() const { return playing_; }
  [[nodiscard]] std::int64_t step_number() const { return step_at(replay_, time_s_); }
  [[nodiscard]] std::int64_t last_step() const;
  [[nodiscard]] int speed() const { return speed_; }
  /// "×1/4".
  [[nodiscard]] std::string speed_words() const;
  /// From onset to the end of the stimulus or of the last mark, whichever is later.
  [[nodiscard]] double span_s() const { return span_s_; }

 private:
  const ReplayView& replay_;
  double span_s_{0.0};
  double time_s_{0.0};
  bool playing_{true};
  int speed_{0};  ///< a power of two
};

/// What can be jumped to. Collisions are those of any level.
enum class JumpTarget { kCollision, kClick, kLateFrame, kResponse };

/// "collision", "click", "late frame", "answer".
[[nodiscard]] const char* word_of(JumpTarget target);

[[nodiscard]] bool has_target(const std::vector<TimelineMark>& marks, JumpTarget target);

/// When the next (direction 1) or the last (−1) of them begins, more than half a step of `step_hz`
/// from `time_s`: marks of one moment are one jump. None: there is none that way.
[[nodiscard]] std::optional<double> jump_from(const std::vector<TimelineMark>& marks,
                                              JumpTarget target, double time_s, int direction,
                                              double step_hz);

}  // namespace impetus::inline viewing
