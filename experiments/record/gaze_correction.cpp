// SPDX-License-Identifier: MIT
#include "experiments/record/gaze_correction.hpp"

namespace impetus::inline record {
namespace {

ScreenPoint operator+(const ScreenPoint& a, const ScreenPoint& b) {
  return {a.x_m + b.x_m, a.y_m + b.y_m};
}
ScreenPoint operator-(const ScreenPoint& a, const ScreenPoint& b) {
  return {a.x_m - b.x_m, a.y_m - b.y_m};
}
ScreenPoint operator/(const ScreenPoint& a, double count) { return {a.x_m / count, a.y_m / count}; }

/// Sums of products about the means: the normal equations of both axes.
struct Moments {
  double gaze_xx{0.0}, gaze_xy{0.0}, gaze_yy{0.0};
  ScreenPoint with_x;  ///< of the points' places with the gaze's x
  ScreenPoint with_y;
};

Moments moments_of(const std::vector<FixatedPoint>& points, const FixatedPoint& mean) {
  Moments sums;
  for (const FixatedPoint& point : points) {
    const ScreenPoint gaze = point.gaze - mean.gaze;
    const ScreenPoint shown = point.shown - mean.shown;
    sums.gaze_xx += gaze.x_m * gaze.x_m;
    sums.gaze_xy += gaze.x_m * gaze.y_m;
    sums.gaze_yy += gaze.y_m * gaze.y_m;
    sums.with_x = sums.with_x + ScreenPoint{gaze.x_m * shown.x_m, gaze.x_m * shown.y_m};
    sums.with_y = sums.with_y + ScreenPoint{gaze.y_m * shown.x_m, gaze.y_m * shown.y_m};
  }
  return sums;
}

FixatedPoint mean_of(const std::vector<FixatedPoint>& points) {
  FixatedPoint sum{};
  for (const FixatedPoint& point : points) {
    sum = {sum.shown + point.shown, sum.gaze + point.gaze};
  }
  const auto count = static_cast<double>(points.size());
  return {sum.shown / count, sum.gaze / count};
}

}  // namespace

std::optional<GazeCorrection> fit_gaze_correction(const std::vector<FixatedPoint>& points) {
  if (points.size() < kLeastFixatedPoints) {
    return std::nullopt;
  }
  const FixatedPoint mean = mean_of(points);
  const Moments sums = moments_of(points, mean);
  const double determinant = sums.gaze_xx * sums.gaze_yy - sums.gaze_xy * sums.gaze_xy;
  const double spread = sums.gaze_xx + sums.gaze_yy;
  constexpr double kFlat = 1e-4;  // a hundredth as wide as long, or less, is a line
  if (determinant <= kFlat * spread * spread) {
    return std::nullopt;
  }
  GazeCorrection fit;
  fit.xx = (sums.with_x.x_m * sums.gaze_yy - sums.with_y.x_m * sums.gaze_xy) / determinant;
  fit.xy = (sums.with_y.x_m * sums.gaze_xx - sums.with_x.x_m * sums.gaze_xy) / determinant;
  fit.yx = (sums.with_x.y_m * sums.gaze_yy - sums.with_y.y_m * sums.gaze_xy) / determinant;
  fit.yy = (sums.with_y.y_m * sums.gaze_xx - sums.with_x.y_m * sums.gaze_xy) / determinant;
  fit.x0_m = mean.shown.x_m - fit.xx * mean.gaze.x_m - fit.xy * mean.gaze.y_m;
  fit.y0_m = mean.shown.y_m - fit.yx * mean.gaze.x_m - fit.yy * mean.gaze.y_m;
  return fit;
}

}  // namespace impetus::inline record
