// SPDX-License-Identifier: MIT
#include "experiments/viewers/screen_measures.hpp"

#include <cstdio>

#include "experiments/record/lab_screen.hpp"

namespace impetus::inline viewers {
namespace {

bool is_plausible(const std::optional<double>& entered_cm, const PlausibleMeasure& measure) {
  return entered_cm && *entered_cm >= measure.least_cm && *entered_cm <= measure.most_cm;
}

}  // namespace

std::string centimetres(double length_m) {
  char text[40];
  std::snprintf(text, sizeof text, "%g", 100.0 * length_m);
  return length_m > 0.0 ? text : "";
}

std::string objection_to(const EnteredMeasures& entered) {
  for (std::size_t i = 0; i < kMeasures; ++i) {
    const PlausibleMeasure& measure = kPlausible[i];
    if (is_plausible(entered[i], measure)) {
      continue;
    }
    char there[40] = "nothing";
    if (entered[i]) {
      std::snprintf(there, sizeof there, "%g", *entered[i]);
    }
    char text[160];
    std::snprintf(text, sizeof text, "The %s: expected %g to %g cm, got %s.", measure.name,
                  measure.least_cm, measure.most_cm, there);
    return text;
  }
  return "";
}

std::optional<PixelsPerMetre> pixels_per_metre(const EnteredMeasures& entered, int width_px,
                                               int height_px) {
  if (!is_plausible(entered[0], kPlausible[0]) || !is_plausible(entered[1], kPlausible[1])) {
    return std::nullopt;
  }
  return PixelsPerMetre{100.0 * width_px / *entered[0], 100.0 * height_px / *entered[1]};
}

std::string warning_about(const EnteredMeasures& entered, int width_px, int height_px) {
  if (!pixels_per_metre(entered, width_px, height_px)) {
    return "";
  }
  const ScreenGeometry screen{*entered[0] / 100.0, *entered[1] / 100.0, width_px, height_px, 0.0};
  if (has_square_pixels(screen)) {
    return "";
  }
  return "Of " + std::to_string(width_px) + " × " + std::to_string(height_px) +
         " pixels each would be " + pixel_words(screen) +
         ": not square within 1 %. Please check width and height.";
}

ScreenGeometry geometry_of(const EnteredMeasures& entered, int width_px, int height_px) {
  return {*entered[0] / 100.0, *entered[1] / 100.0, width_px, height_px, *entered[2] / 100.0};
}

}  // namespace impetus::inline viewers
