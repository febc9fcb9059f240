// SPDX-License-Identifier: MIT
#include "engine/numerics/trigonometry.hpp"

#include <cmath>
#include <numbers>

namespace impetus::inline numerics {
namespace {

/// Taylor series on |x| ≤ π/4 radians, where the first term left out is below 1e-18.
SineCosine on_first_octant(double x) {
  const double square = x * x;
  double sine = 0.0;
  double cosine = 0.0;
  for (int term = 9; term >= 1; --term) {
    sine = -square / ((2.0 * term) * (2.0 * term + 1.0)) * (1.0 + sine);
    cosine = -square / ((2.0 * term - 1.0) * (2.0 * term)) * (1.0 + cosine);
  }
  return {x * (1.0 + sine), 1.0 + cosine};
}

/// atan(x) for x in [0, 1]: atan(x) = atan(k/8) + atan(t), t = (x − k/8) / (1 + x k/8), with k/8
/// the eighth nearest to x, so |t| ≤ 1/16 and the first term of the series left out is below 1e-21.
double atan_on_unit(double x) {
  constexpr double kAtanOfEighths[] = {0x0.0p+0,
                                       0x1.fd5ba9aac2f6ep-4,
                                       0x1.f5b75f92c80ddp-3,
                                       0x1.6f61941e4def1p-2,
                                       0x1.dac670561bb4fp-2,
                                       0x1.1e00babdefeb4p-1,
                                       0x1.4978fa3269ee1p-1,
                                       0x1.700a7c5784634p-1,
                                       0x1.921fb54442d18p-1};
  const int eighths = static_cast<int>(std::floor(8.0 * x + 0.5));
  const double nearest = eighths / 8.0;
  const double rest = (x - nearest) / (1.0 + x * nearest);
  const double square = rest * rest;
  double series = 0.0;
  for (int power = 17; power >= 3; power -= 2) {
    series = square * (1.0 / power - series);
  }
  return kAtanOfEighths[eighths] + rest * (1.0 - series);
}

}  // namespace

SineCosine sine_cosine_deg(double angle_deg) {
  // floor and the subtraction are exact in binary for these sizes, hence the same everywhere.
  const double quarter_turns = std::floor(angle_deg / 90.0 + 0.5);
  const double rest_deg = angle_deg - 90.0 * quarter_turns;
  const SineCosine base = on_first_octant(rest_deg * (std::numbers::pi / 180.0));
  switch (static_cast<long long>(quarter_turns) & 3) {
    case 0:
      return base;
    case 1:
      return {base.cosine, -base.sine};
    case 2:
      return {-base.sine, -base.cosine};
    default:
      return {-base.cosine, base.sine};
  }
}

double atan2_rad(double y, double x) {
  const double width = x < 0.0 ? -x : x;
  const double height = y < 0.0 ? -y : y;
  if (width == 0.0 && height == 0.0) {
    return 0.0;
  }
  const double ratio = height <= width ? height / width : width / height;
  if (!(ratio <= 1.0)) {
    return ratio;  // not a number: no index into the table
  }
  double angle =
      height <= width ? atan_on_unit(ratio) : 0.5 * std::numbers::pi - atan_on_unit(ratio);
  angle = x < 0.0 ? std::numbers::pi - angle : angle;
  return y < 0.0 ? -angle : angle;
}

double degrees(double angle_rad) { return angle_rad * (180.0 / std::numbers::pi); }

double metres_per_degree(double viewing_distance_m) {
  const SineCosine half = sine_cosine_deg(0.5);
  return 2.0 * viewing_distance_m * (half.sine / half.cosine);
}

}  // namespace impetus::inline numerics
