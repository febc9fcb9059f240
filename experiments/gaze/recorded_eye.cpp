// SPDX-License-Identifier: MIT
#include "experiments/gaze/recorded_eye.hpp"

#include <algorithm>
#include <cmath>

#include "engine/numerics/elementary_functions.hpp"

namespace impetus::inline gaze {
namespace {

ScreenPoint on_screen(GazeRecording::Unit unit, double x, double y, const ScreenGeometry& screen) {
  using U = GazeRecording::Unit;
  const double m_per_deg = metres_per_degree(screen.viewing_distance_m);
  switch (unit) {
    case U::kMetres:
      return {x, y};
    case U::kDegrees:
      return {x * m_per_deg, y * m_per_deg};
    case U::kPixels:
      return {(x / screen.width_px - 0.5) * screen.width_m,
              (0.5 - y / screen.height_px) * screen.height_m};
    case U::kSharesDown:
      return {(x - 0.5) * screen.width_m, (0.5 - y) * screen.height_m};
    case U::kSharesUp:
      return {(x - 0.5) * screen.width_m, (y - 0.5) * screen.height_m};
  }
  return {};
}

}  // namespace

Fixation GazeRecording::place(const Sample& sample, const ScreenGeometry& screen) const {
  if (!sample.valid) {
    return std::nullopt;
  }
  const ScreenPoint point = on_screen(unit, sample.x, sample.y, screen);
  const bool is_on =
      std::abs(point.x_m) <= 0.5 * screen.width_m && std::abs(point.y_m) <= 0.5 * screen.height_m;
  return is_on ? Fixation(point) : std::nullopt;
}

void RecordedEye::begins(std::int64_t slot) {
  const auto main = std::find(slots_.begin(), slots_.end(), slot);
  const bool has_own = main != slots_.end() && recording_->trials.size() > 1;
  trial_ = has_own ? static_cast<std::size_t>(main - slots_.begin()) : 0;
  next_ = 0;
  awaits_onset_ = true;
  onset_ns_.reset();
}

void RecordedEye::shown(const Picture& picture, const Flip& flip) {
  target_ = picture.target;
  if (awaits_onset_ && !picture.fixation_cross) {
    onset_ns_ = flip.flipped_ns;
    awaits_onset_ = false;
  }
}

std::vector<GazeSample> RecordedEye::take_samples() {
  const std::int64_t now_ns = clock_->now_ns();
  if (target_) {
    return {{now_ns, target_}};
  }
  std::vector<GazeSample> samples;
  const std::vector<GazeRecording::Sample>& path = recording_->trials[trial_];
  for (; onset_ns_ && next_ < path.size(); ++next_) {
    const GazeRecording::Sample& sample = path[next_];
    const std::int64_t taken_ns = *onset_ns_ + std::llround(sample.time_s * 1e9);
    if (taken_ns > now_ns) {
      break;
    }
    const Fixation at = recording_->place(sample, screen_);
    samples.push_back({taken_ns, at,
                       at             ? GazeLoss::kNone
                       : sample.valid ? GazeLoss::kOffScreen
                                      : GazeLoss::kLost});
  }
  return samples;
}

}  // namespace impetus::inline gaze
