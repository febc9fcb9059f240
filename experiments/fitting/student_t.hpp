// Student's t, where a mean over few people is judged.
// SPDX-License-Identifier: MIT
#pragma once

namespace impetus::inline fitting {

/// Its 97.5 % point; Hill 1970's expansion, right to three digits from 3 degrees of freedom on.
constexpr double student_t(double freedom) {
  constexpr double z = 1.959964;
  constexpr double z3 = z * z * z;
  constexpr double z5 = z3 * z * z;
  constexpr double g1 = (z3 + z) / 4.0;
  constexpr double g2 = (5.0 * z5 + 16.0 * z3 + 3.0 * z) / 96.0;
  constexpr double g3 = (3.0 * z5 * z * z + 19.0 * z5 + 17.0 * z3 - 15.0 * z) / 384.0;
  return z + g1 / freedom + g2 / (freedom * freedom) + g3 / (freedom * freedom * freedom);
}

}  // namespace impetus::inline fitting
