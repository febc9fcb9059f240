// SPDX-License-Identifier: MIT
#include "experiments/session/calibration_run.hpp"

#include <algorithm>
#include <cmath>

namespace impetus::inline session {
namespace {

constexpr double kSettlingShare = 0.5;

/// Shows points one after the other and keeps what was sampled.
class Run {
 public:
  Run(double point_ms, const SessionProgress& progress, const Ports& ports)
      : ports_(ports),
        hz_(ports.display.refresh_hz()),
        frames_(std::max<std::int64_t>(1, std::llround(point_ms / 1e3 * hz_))) {
    picture_.viewer = viewer_at(ports.display.geometry(), 0.0);
    picture_.pointer = ports.gaze->is_pointer();
    picture_.progress = progress;
  }

  PointRun through(const std::vector<ScreenPoint>& points) {
    ports_.display.restart_grid();
    static_cast<void>(ports_.gaze->take_samples());  // of before
    for (const ScreenPoint& point : points) {
      run_.points.push_back({point, {}});
      if (!show(point)) {
        return std::move(run_);
      }
    }
    take_samples();
    run_.began_ns = onsets_ns_.front();
    run_.sampling_hz = sampling_hz_of(samples_);
    share_out();
    return std::move(run_);
  }

 private:
  bool show(const ScreenPoint& point) {
    picture_.target = point;
    for (std::int64_t frame = 0; frame < frames_; ++frame) {
      const Flip flip = ports_.display.show(picture_);
      ports_.gaze->shown(picture_, flip);
      if (frame == 0) {
        onsets_ns_.push_back(flip.flipped_ns);
      }
      take_samples();
      run_.interruption = ports_.input.interruption();
      if (run_.interruption != Interruption::kNone) {
        return false;
      }
    }
    return true;
  }

  void take_samples() {
    const std::vector<GazeSample> samples = ports_.gaze->take_samples();
    samples_.insert(samples_.end(), samples.begin(), samples.end());
  }

  /// Each sample to the point that was shown when it was taken, if its eye had had time to settle.
  void share_out() {
    const double point_ns = static_cast<double>(frames_) * 1e9 / hz_;
    const auto settling_ns = static_cast<std::int64_t>(kSettlingShare * point_ns);
    const std::int64_t end_ns = onsets_ns_.back() + static_cast<std::int64_t>(point_ns);
    for (std::size_t i = 0; i < onsets_ns_.size(); ++i) {
      const std::int64_t until_ns = i + 1 < onsets_ns_.size() ? onsets_ns_[i + 1] : end_ns;
      std::copy_if(samples_.begin(), samples_.end(), std::back_inserter(run_.points[i].samples),
                   [&](const GazeSample& sample) {
                     return sample.taken_ns >= onsets_ns_[i] + settling_ns &&
                            sample.taken_ns < until_ns;
                   });
    }
  }

  const Ports& ports_;
  double hz_;
  std::int64_t frames_;  ///< of each point
  Picture picture_;
  PointRun run_;
  std::vector<std::int64_t> onsets_ns_;
  std::vector<GazeSample> samples_;
};

}  // namespace

PointRun run_points(const std::vector<ScreenPoint>& points, double point_ms,
                    const SessionProgress& progress, const Ports& ports) {
  return Run(point_ms, progress, ports).through(points);
}

std::vector<ScreenPoint> nine_points(const ScreenGeometry& screen, double share) {
  std::vector<ScreenPoint> points;
  for (const double y : {0.5, 0.0, -0.5}) {
    for (const double x : {-0.5, 0.0, 0.5}) {
      points.push_back({x * share * screen.width_m, y * share * screen.height_m});
    }
  }
  return points;
}

PointRun corrected(PointRun run, const GazeCorrection& correction) {
  for (PointSamples& point : run.points) {
    for (GazeSample& sample : point.samples) {
      sample.at = correction.corrected(sample.at);
    }
  }
  return run;
}

}  // namespace impetus::inline session
