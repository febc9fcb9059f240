// SPDX-License-Identifier: MIT
#include "experiments/timing/flip_plot.hpp"

#include <algorithm>
#include <cstdio>

#include "experiments/timing/timing_verdicts.hpp"

namespace impetus::inline timing {
namespace {

constexpr double kWidth = 640.0;
constexpr double kHeight = 96.0;
constexpr double kMargin = 44.0;  // for the numbers on the left
constexpr double kPeriods = 3.0;

double height_of(double interval_ms, double period_ms) {
  const double share = std::min(1.0, interval_ms / (kPeriods * period_ms));
  return kHeight * (1.0 - share);
}

std::string period_line(int periods, double period_ms) {
  const double y = height_of(periods * period_ms, period_ms);
  char text[240];
  std::snprintf(text, sizeof text,
                "<line x1='%g' x2='%g' y1='%.1f' y2='%.1f' stroke='#ccc'/>"
                "<text x='%g' y='%.1f' text-anchor='end'>%.1f</text>",
                kMargin, kWidth, y, y, kMargin - 4.0, y + 4.0, periods * period_ms);
  return text;
}

}  // namespace

std::string flip_plot(const FlipSeries& run, double nominal_hz) {
  const double period_ms = 1e3 / nominal_hz;
  char opening[160];
  std::snprintf(opening, sizeof opening,
                "<svg viewBox='0 -6 %g %g' width='%g' role='img' aria-label='", kWidth + 6.0,
                kHeight + 14.0, kWidth);
  std::string svg = opening + ("intervals with " + pictured(run.bodies)) + "'>";
  svg += period_line(1, period_ms) + period_line(2, period_ms);
  const auto count = static_cast<double>(run.intervals_ms.size());
  for (std::size_t i = 0; i < run.intervals_ms.size(); ++i) {
    const bool late = run.missed_slots[i + 1] > 0;
    char dot[120];
    std::snprintf(dot, sizeof dot, "<circle cx='%.1f' cy='%.1f' r='%s' fill='%s'/>",
                  kMargin + (kWidth - kMargin) * static_cast<double>(i) / count,
                  height_of(run.intervals_ms[i], period_ms), late ? "2.5" : "1.2",
                  late ? "#c0392b" : "#2c5f8a");
    svg += dot;
  }
  return svg + "</svg>";
}

}  // namespace impetus::inline timing
