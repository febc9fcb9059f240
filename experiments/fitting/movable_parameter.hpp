// A parameter that a fit moves, on a scale without ends.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace impetus::inline fitting {

/// A parameter that may be moved, and the scale on which that is done: numbers as they are in steps
/// of `unit`, what is positive by its logarithm, a probability by its logit.
struct MovableParameter {
  enum class Scale { kLinear, kLog, kShare };

  std::string name;
  double* place{nullptr};
  Scale scale{Scale::kLinear};
  double unit{1.0};
  bool ends_at_zero{false};  ///< 0 is a value like others: nobody lapses, all are alike, a step
  double least{0.0};         ///< that a file may say

  [[nodiscard]] double on_scale(double value) const;
  [[nodiscard]] double from_scale(double x) const;
  /// How far on the scale is as good as infinitely far.
  [[nodiscard]] double reach() const { return scale == Scale::kLinear ? 60.0 : 12.0; }
};

}  // namespace impetus::inline fitting
