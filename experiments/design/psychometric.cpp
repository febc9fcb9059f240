// SPDX-License-Identifier: MIT
#include "experiments/design/psychometric.hpp"

#include <numbers>

#include "engine/numerics/elementary_functions.hpp"

namespace impetus::inline design {
namespace {

constexpr double kDecibelsPerDecade = 20.0;

/// w, of which the Weibull function is 1 − exp(−w).
double weibull_exponent(QuestPlus::Scale scale, double x, const PsychometricParameters& p) {
  if (scale == QuestPlus::Scale::kLinear) {
    return x > 0.0 ? exp_of(p.slope * log_of(x / p.threshold)) : 0.0;
  }
  const double unit = scale == QuestPlus::Scale::kDecibel ? kDecibelsPerDecade : 1.0;
  return exp_of(std::numbers::ln10 * p.slope * (x - p.threshold) / unit);
}

}  // namespace

double on_scale(QuestPlus::Scale scale, double level) {
  switch (scale) {
    case QuestPlus::Scale::kLog10:
      return log10_of(level);
    case QuestPlus::Scale::kDecibel:
      return kDecibelsPerDecade * log10_of(level);
    default:
      return level;
  }
}

bool is_defined(QuestPlus::Function function, QuestPlus::Scale scale, double x, double threshold) {
  const bool of_ratio =
      function == QuestPlus::Function::kWeibull && scale == QuestPlus::Scale::kLinear;
  return !of_ratio || (x >= 0.0 && threshold > 0.0);
}

double positive_chance(QuestPlus::Function function, QuestPlus::Scale scale, double x,
                       const PsychometricParameters& p) {
  const double range = 1.0 - p.guess_rate - p.lapse_rate;
  if (function == QuestPlus::Function::kNormal) {
    return p.guess_rate + range * cumulative_normal((x - p.threshold) / p.slope);
  }
  return 1.0 - p.lapse_rate - range * exp_of(-weibull_exponent(scale, x, p));
}

}  // namespace impetus::inline design
