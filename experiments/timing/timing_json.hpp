// The report for programs: every number of the page, the criteria, and the raw intervals.
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include "experiments/timing/timing_report.hpp"

namespace impetus::inline timing {

/// What could not be measured is null.
nlohmann::ordered_json timing_json(const TimingReport& report);

}  // namespace impetus::inline timing
