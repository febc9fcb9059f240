// A run of flips as a small picture for the page: one dot per interval, over time.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "experiments/timing/timing_report.hpp"

namespace impetus::inline timing {

/// An SVG element whose height is three nominal periods; longer intervals lie on its upper edge.
std::string flip_plot(const FlipSeries& run, double nominal_hz);

}  // namespace impetus::inline timing
