// Student's t, where a mean of few numbers is judged.
// SPDX-License-Identifier: MIT
#pragma once

namespace impetus::inline tables {

/// Its 97.5 % point with so many degrees of freedom, a whole number from 1 on; within .3 %. From 4
/// on by the expansion of Cornish and Fisher (Abramowitz and Stegun 1964, 26.7.5).
constexpr double student_t(double freedom) {
  if (freedom < 4.0) {
    return freedom < 2.0 ? 12.7062 : freedom < 3.0 ? 4.30265 : 3.18245;
  }
  constexpr double z = 1.959964;
  constexpr double z3 = z * z * z;
  constexpr double z5 = z3 * z * z;
  constexpr double g1 = (z3 + z) / 4.0;
  constexpr double g2 = (5.0 * z5 + 16.0 * z3 + 3.0 * z) / 96.0;
  constexpr double g3 = (3.0 * z5 * z * z + 19.0 * z5 + 17.0 * z3 - 15.0 * z) / 384.0;
  return z + g1 / freedom + g2 / (freedom * freedom) + g3 / (freedom * freedom * freedom);
}

}  // namespace impetus::inline tables
