// Psychometric functions: the chance of a positive answer to a level, in arithmetic that is the
// same on every machine.
//
//   normal    γ + (1 − γ − λ) Φ((x − t) / s)          s: the slope, a standard deviation
//   weibull   1 − λ − (1 − γ − λ) exp(−w),            s: the slope, an exponent
//             w = (x / t)^s of the level itself, 10^(s (x − t)) of its decimal logarithm,
//             10^(s (x − t) / 20) of decibels         (Watson 2017)
//
// x is the level on its scale, t the threshold, γ the guess rate, λ the lapse rate.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/design/design.hpp"

namespace impetus::inline design {

/// One psychometric function.
struct PsychometricParameters {
  double threshold{0.0};  ///< on the scale
  double slope{1.0};      ///< > 0
  double guess_rate{0.0};
  double lapse_rate{0.0};
};

/// A level on the scale: as it is, its decimal logarithm, or decibels (20 log₁₀). A logarithm's
/// level is above 0.
double on_scale(QuestPlus::Scale scale, double level);

/// Whether the function can be computed at `x` with this threshold: a Weibull function of the level
/// itself needs x ≥ 0 and a threshold above 0.
bool is_defined(QuestPlus::Function function, QuestPlus::Scale scale, double x, double threshold);

/// The chance of a positive answer at `x` on the scale, where is_defined().
double positive_chance(QuestPlus::Function function, QuestPlus::Scale scale, double x,
                       const PsychometricParameters& parameters);

}  // namespace impetus::inline design
