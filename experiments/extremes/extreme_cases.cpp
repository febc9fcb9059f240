// SPDX-License-Identifier: MIT
#include "experiments/extremes/extreme_cases.hpp"

#include <iterator>
#include <utility>

namespace impetus::inline extremes {

const std::vector<ExtremeCase>& extreme_cases() {
  static const std::vector<ExtremeCase> all = [] {
    std::vector<ExtremeCase> cases;
    for (std::vector<ExtremeCase> (*family)() :
         {size_cases, speed_cases, spin_cases, mass_cases, time_step_cases, far_place_cases,
          touch_cases, crowd_cases, budget_cases, tunnelling_cases, not_finite_cases,
          small_number_cases, long_run_cases}) {
      std::vector<ExtremeCase> more = family();
      cases.insert(cases.end(), std::make_move_iterator(more.begin()),
                   std::make_move_iterator(more.end()));
    }
    return cases;
  }();
  return all;
}

}  // namespace impetus::inline extremes
