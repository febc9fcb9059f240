// The sounds of one stimulus: which contacts sound, when, and what became of it.
//
//   before    the scene is run ahead, where its steps follow from it alone: its contacts are known
//   flips     each says anew when the contact will be shown; a tenth of a second before its sound
//             it is handed over, so that a late frame before that moves both
//   after     when each onset left the device
//
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "experiments/record/sound.hpp"
#include "experiments/run/live_run.hpp"

namespace impetus::inline session {

/// Hands sounds over as their time comes.
class StimulusSounds {
 public:
  /// `begins` is the stimulus, of which nothing was run yet; its scene has a sound. `sounds` must
  /// outlive this.
  StimulusSounds(const LiveRun& begins, std::int64_t interval, double refresh_hz, Sounds& sounds);

  /// A frame was flipped: of the scene from 0 on; of the cross before it, below. `so_far` are the
  /// contacts that have come.
  void flipped(std::int64_t frame, std::int64_t flipped_ns,
               const std::vector<CollisionRecord>& so_far);

  /// No further frame comes; what belongs to those that were shown is handed over.
  void end();

  /// What was handed over, with the instants that are known by now.
  std::vector<SoundRecord> take_records();

 private:
  /// A sound whose contact is shown at `frame`.
  struct Planned {
    std::optional<std::int64_t> step;
    std::int64_t frame{0};
    double loudness{0.0};
    std::optional<std::int64_t> number{};  ///< of the device, once handed over
    std::int64_t intended_ns{0};
    std::optional<std::int64_t> shown_ns{};
  };

  void plan_contacts(const std::vector<CollisionRecord>& contacts);
  [[nodiscard]] std::int64_t frame_of(double time_s) const;
  void hand_over(Planned& planned);

  SoundTask task_;
  double step_hz_;
  double refresh_hz_;
  std::int64_t interval_;
  Sounds& sounds_;
  bool is_foreseen_;
  std::size_t planned_contacts_{0};  ///< of those that have come
  double first_impulse_Ns_{0.0};
  std::vector<Planned> planned_;
  std::int64_t last_frame_{std::numeric_limits<std::int64_t>::min()};  ///< flipped; at first none
};

}  // namespace impetus::inline session
