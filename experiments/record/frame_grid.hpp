// The absolute grid of frames: slot n is due at anchor + n / refresh, so nothing drifts.
//
//   slot      0        1        2        3        4
//   due       |--------|--------|--------|--------|
//   flips     x        x             x   .        x     frame 2 was late: it took slot 3,
//   frames    0        1             2            3     one slot was missed, none is skipped
//
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>

namespace impetus::inline record {

/// What one flip measured.
struct Flip {
  std::int64_t scheduled_ns{0};  ///< when the slot was due
  std::int64_t submitted_ns{0};  ///< when drawing was handed to the display
  std::int64_t flipped_ns{0};    ///< when the flip had happened (the session says by which stamp)
  std::int64_t missed_slots{0};  ///< slots that went by without their frame

  [[nodiscard]] std::int64_t lateness_ns() const { return flipped_ns - scheduled_ns; }
  /// Late: the frame came a slot or more after the one it was due in.
  [[nodiscard]] bool late() const { return missed_slots > 0; }
};

/// Which slots are taken, and when the next is due.
class FrameGrid {
 public:
  /// `refresh_hz` must be positive.
  explicit FrameGrid(double refresh_hz) : period_ns_(1e9 / refresh_hz) {}

  /// Slot 0 is at `anchor_ns`; the next frame is due one slot later.
  void restart(std::int64_t anchor_ns) {
    anchor_ns_ = anchor_ns;
    slot_ = 0;
  }

  /// When the next frame is due.
  [[nodiscard]] std::int64_t next_due_ns() const { return due_ns(slot_ + 1); }

  /// Takes the flip of the next frame: it is put in the slot nearest to when it happened, never
  /// before the one it was due in.
  Flip flipped(std::int64_t submitted_ns, std::int64_t flipped_ns);

  [[nodiscard]] double period_ns() const { return period_ns_; }

 private:
  [[nodiscard]] std::int64_t due_ns(std::int64_t slot) const;

  double period_ns_;
  std::int64_t anchor_ns_{0};
  std::int64_t slot_{0};
};

/// The frames that cover a duration; whole for every duration that a protocol's check passed.
inline std::int64_t whole_frames(double duration_s, double refresh_hz) {
  constexpr double kOfAFrame = 1e-6;  // what rounding may make of a whole number
  return static_cast<std::int64_t>(std::ceil(duration_s * refresh_hz - kOfAFrame));
}

}  // namespace impetus::inline record
