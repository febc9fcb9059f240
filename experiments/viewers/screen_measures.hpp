// The three measures of a screen as they are entered: what is plausible, and what they imply.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <string>

#include "engine/scheduling/viewer.hpp"

namespace impetus::inline viewers {

/// Width, height, viewing distance.
inline constexpr std::size_t kMeasures = 3;

struct PlausibleMeasure {
  const char* name;
  const char* label;
  double least_cm;
  double most_cm;
};
inline constexpr std::array<PlausibleMeasure, kMeasures> kPlausible{
    {{"width", "Width of the picture (cm)", 10.0, 300.0},
     {"height", "Height of the picture (cm)", 10.0, 200.0},
     {"viewing distance", "Viewing distance (cm)", 20.0, 300.0}}};

/// In centimetres; nothing where no number stands.
using EnteredMeasures = std::array<std::optional<double>, kMeasures>;

/// "37.6" for 0.376 m; empty for 0.
std::string centimetres(double length_m);

/// One sentence naming what was expected and what was there; empty when all are plausible.
std::string objection_to(const EnteredMeasures& entered);

/// One sentence when the pixels come out non-square by more than 1 %; otherwise empty.
std::string warning_about(const EnteredMeasures& entered, int width_px, int height_px);

struct PixelsPerMetre {
  double across{0.0};
  double down{0.0};
};

/// Nothing while width or height is implausible.
std::optional<PixelsPerMetre> pixels_per_metre(const EnteredMeasures& entered, int width_px,
                                               int height_px);

/// `entered` must be plausible.
ScreenGeometry geometry_of(const EnteredMeasures& entered, int width_px, int height_px);

}  // namespace impetus::inline viewers
