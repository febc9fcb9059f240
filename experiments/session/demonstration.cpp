// SPDX-License-Identifier: MIT
#include "experiments/session/demonstration.hpp"

#include <algorithm>

#include "experiments/record/frame_grid.hpp"
#include "experiments/run/playback.hpp"

namespace impetus::inline session {

Interruption show_demonstration(const std::string& id, const Script& script,
                                const SessionProgress& progress, const Ports& ports) {
  Playback playback(ports.scenes.stage_demonstration(id, ports.display.geometry()), 0,
                    ports.work_clock);
  const double hz = ports.display.refresh_hz();
  const std::int64_t interval = whole_frames(script.timing.interval_ms / 1e3, hz);
  const std::int64_t last = whole_frames(playback.scene().duration_s, hz);
  ports.display.restart_grid();
  for (std::int64_t frame = -interval; frame <= last; ++frame) {
    const double time_s = std::max(0.0, static_cast<double>(frame) / hz);
    const std::vector<Pose> poses = frame < 0 ? std::vector<Pose>{} : playback.poses_at(time_s);
    ports.display.show(picture_of(playback.scene(), poses, time_s, progress));
    const Interruption interruption = ports.input.interruption();
    if (interruption != Interruption::kNone) {
      return interruption;
    }
  }
  return Interruption::kNone;
}

}  // namespace impetus::inline session
