// All cases at the extremes, by family.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "experiments/extremes/extreme_case.hpp"

namespace impetus::inline extremes {

/// In the order in which they are reported: families together.
const std::vector<ExtremeCase>& extreme_cases();

std::vector<ExtremeCase> size_cases();
std::vector<ExtremeCase> speed_cases();
std::vector<ExtremeCase> spin_cases();
std::vector<ExtremeCase> mass_cases();
std::vector<ExtremeCase> time_step_cases();
std::vector<ExtremeCase> far_place_cases();
std::vector<ExtremeCase> touch_cases();
std::vector<ExtremeCase> crowd_cases();
std::vector<ExtremeCase> budget_cases();
std::vector<ExtremeCase> tunnelling_cases();
std::vector<ExtremeCase> not_finite_cases();
std::vector<ExtremeCase> small_number_cases();
std::vector<ExtremeCase> long_run_cases();

}  // namespace impetus::inline extremes
