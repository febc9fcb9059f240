// Where a replay stands: its time, its speed, and how keys and flips move it.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "experiments/session/ports.hpp"
#include "experiments/session/replay_view.hpp"

namespace impetus {

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
  /// Slower (−1) or faster (+1): 1, 1/2, 1/4, 1/10.
  void change_speed(int direction);
  /// Stands still at this time.
  void seek(double time_s);

  [[nodiscard]] double time_s() const { return time_s_; }
  [[nodiscard]] bool playing() const { return playing_; }
  [[nodiscard]] std::int64_t step_number() const;
  [[nodiscard]] std::int64_t last_step() const;
  [[nodiscard]] std::string speed() const;
  /// From onset to the end of the stimulus or of the last mark, whichever is later.
  [[nodiscard]] double span_s() const { return span_s_; }

  /// What the present step was told of the gaze.
  [[nodiscard]] GazeInput gaze() const { return gaze_of_step(replay_, step_number()); }
  /// The detail of each body's collisions at the present step; none where it is not known.
  [[nodiscard]] std::vector<BodyDetail> details() const;
  /// The bodies as they are now, poses between steps included.
  [[nodiscard]] std::vector<PosedBody> bodies() const;

 private:
  const ReplayView& replay_;
  double span_s_{0.0};
  double time_s_{0.0};
  bool playing_{true};
  std::size_t speed_{0};
};

}  // namespace impetus
