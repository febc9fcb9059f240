// SPDX-License-Identifier: MIT
#include "experiments/observers/gap_visibility.hpp"

#include <cmath>

namespace impetus::inline observers {

double visible_frequency_at(double speed_deg_s) {
  if (speed_deg_s <= 0.825) {
    return 60.0;
  }
  return speed_deg_s <= 118.3 ? 57.69 - 27.78 * std::log10(speed_deg_s) : 0.1;
}

double gap_threshold_arcmin(double at_rest_arcmin, double eccentricity_deg, double speed_deg_s) {
  return at_rest_arcmin * (1.0 + eccentricity_deg / 2.3) *
         (60.0 / visible_frequency_at(speed_deg_s));
}

}  // namespace impetus::inline observers
