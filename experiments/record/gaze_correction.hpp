// What a calibration does: maps where a tracker says that the eye looks to where it looked.
//
//   x' = x0 + xx·x + xy·y        an affine map of the screen's plane, in metres: it takes away
//   y' = y0 + yx·x + yy·y        an offset, a gain and a turn, and goes on sensibly beyond the
//   points
//
// Fitted by least squares to the points of a calibration, with the four operations alone, so that
// the same samples give the same map on every machine. A polynomial of the second order would bend
// outside of the points, and nine means do not tell its terms from noise.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "engine/scheduling/viewer.hpp"

namespace impetus::inline record {

/// The default changes nothing. Offsets in metres.
struct GazeCorrection {
  double x0_m{0.0};
  double xx{1.0};
  double xy{0.0};
  double y0_m{0.0};
  double yx{0.0};
  double yy{1.0};

  /// Where was looked, when the tracker says `raw`.
  [[nodiscard]] ScreenPoint corrected(const ScreenPoint& raw) const {
    return {x0_m + xx * raw.x_m + xy * raw.y_m, y0_m + yx * raw.x_m + yy * raw.y_m};
  }
  [[nodiscard]] Fixation corrected(const Fixation& raw) const {
    return raw ? Fixation(corrected(*raw)) : std::nullopt;
  }

  friend bool operator==(const GazeCorrection&, const GazeCorrection&) = default;
};

/// A point that was looked at, and the mean of the raw samples meanwhile.
struct FixatedPoint {
  ScreenPoint shown;
  ScreenPoint gaze;
};

inline constexpr std::size_t kLeastFixatedPoints = 4;

/// The map that brings the gaze nearest to the points shown, in the sum of squared distances. None
/// with fewer than kLeastFixatedPoints, or when the gaze stayed on a line or in one place.
std::optional<GazeCorrection> fit_gaze_correction(const std::vector<FixatedPoint>& points);

}  // namespace impetus::inline record
