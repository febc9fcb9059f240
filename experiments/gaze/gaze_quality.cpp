// SPDX-License-Identifier: MIT
#include "experiments/gaze/gaze_quality.hpp"

#include <algorithm>
#include <cmath>

namespace impetus::inline gaze {
namespace {

/// A mean or a root of a mean square, as it grows.
struct Pool {
  double sum{0.0};
  std::int64_t count{0};

  void add(double value) {
    sum += value;
    ++count;
  }
  void add(const Pool& other) {
    sum += other.sum;
    count += other.count;
  }
  [[nodiscard]] std::optional<double> mean() const {
    return count > 0 ? std::optional(sum / static_cast<double>(count)) : std::nullopt;
  }
  [[nodiscard]] std::optional<double> root() const {
    return count > 0 ? std::optional(std::sqrt(sum / static_cast<double>(count))) : std::nullopt;
  }
};

/// Of one point: distances to it, squares from sample to sample, squares to the mean.
struct PointPools {
  Pool distance_deg;
  Pool step_deg2;
  Pool spread_deg2;
};

double angle_deg(const Viewer& viewer, const ScreenPoint& a, const ScreenPoint& b) {
  return visual_angle_deg(viewer, on_screen(viewer, a), on_screen(viewer, b));
}

Fixation mean_place(const std::vector<GazeSample>& samples) {
  ScreenPoint sum;
  double count = 0.0;
  for (const GazeSample& sample : samples) {
    if (sample.at) {
      sum = {sum.x_m + sample.at->x_m, sum.y_m + sample.at->y_m};
      count += 1.0;
    }
  }
  return count > 0.0 ? Fixation({sum.x_m / count, sum.y_m / count}) : std::nullopt;
}

PointPools pools_of(const Viewer& viewer, const PointSamples& point) {
  PointPools pools;
  const Fixation mean = mean_place(point.samples);
  const GazeSample* before = nullptr;
  for (const GazeSample& sample : point.samples) {
    if (sample.at) {
      pools.distance_deg.add(angle_deg(viewer, *sample.at, point.shown));
      const double spread_deg = angle_deg(viewer, *sample.at, *mean);
      pools.spread_deg2.add(spread_deg * spread_deg);
    }
    if (sample.at && before != nullptr && before->at) {
      const double step_deg = angle_deg(viewer, *sample.at, *before->at);
      pools.step_deg2.add(step_deg * step_deg);
    }
    before = &sample;
  }
  return pools;
}

std::int64_t lost_in(const std::vector<GazeSample>& samples) {
  return std::count_if(samples.begin(), samples.end(),
                       [](const GazeSample& sample) { return !sample.at; });
}

}  // namespace

CalibrationPointRecord measured(const Viewer& viewer, const PointSamples& point) {
  const PointPools pools = pools_of(viewer, point);
  return {point.shown,
          mean_place(point.samples),
          pools.distance_deg.mean(),
          pools.step_deg2.root(),
          pools.spread_deg2.root(),
          static_cast<std::int64_t>(point.samples.size()),
          lost_in(point.samples)};
}

CalibrationRecord measured(const Viewer& viewer, const std::vector<PointSamples>& points,
                           double accuracy_limit_deg) {
  CalibrationRecord record;
  record.accuracy_limit_deg = accuracy_limit_deg;
  Pool accuracy_deg;
  Pool lost;
  PointPools together;
  for (const PointSamples& point : points) {
    record.points.push_back(measured(viewer, point));
    const CalibrationPointRecord& row = record.points.back();
    if (row.accuracy_deg) {
      accuracy_deg.add(*row.accuracy_deg);
      record.worst_accuracy_deg =
          std::max(record.worst_accuracy_deg.value_or(0.0), *row.accuracy_deg);
    }
    lost.add(Pool{static_cast<double>(row.lost), row.samples});
    const PointPools pools = pools_of(viewer, point);
    together.step_deg2.add(pools.step_deg2);
    together.spread_deg2.add(pools.spread_deg2);
  }
  record.accuracy_deg = accuracy_deg.mean();
  record.precision_rms_deg = together.step_deg2.root();
  record.precision_sd_deg = together.spread_deg2.root();
  record.lost_share = lost.mean().value_or(1.0);
  record.passed = accuracy_deg.count == static_cast<std::int64_t>(points.size()) &&
                  record.accuracy_deg.value_or(accuracy_limit_deg + 1.0) <= accuracy_limit_deg;
  return record;
}

std::optional<double> sampling_hz_of(const std::vector<GazeSample>& samples) {
  if (samples.size() < 2 || samples.back().taken_ns <= samples.front().taken_ns) {
    return std::nullopt;
  }
  const auto lasted_ns = static_cast<double>(samples.back().taken_ns - samples.front().taken_ns);
  return static_cast<double>(samples.size() - 1) * 1e9 / lasted_ns;
}

}  // namespace impetus::inline gaze
