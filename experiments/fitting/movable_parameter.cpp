// SPDX-License-Identifier: MIT
#include "experiments/fitting/movable_parameter.hpp"

#include <algorithm>
#include <cmath>

namespace impetus::inline fitting {

double MovableParameter::on_scale(double value) const {
  const double smallest = from_scale(-reach());
  switch (scale) {
    case Scale::kLog:
      return std::log(std::max(value, smallest) / unit);
    case Scale::kShare: {
      const double share = std::clamp(value, smallest, 1.0 - smallest);
      return std::log(share / (1.0 - share));
    }
    default:
      return value / unit;
  }
}

double MovableParameter::from_scale(double x) const {
  switch (scale) {
    case Scale::kLog:
      return unit * std::exp(x);
    case Scale::kShare:
      return 1.0 / (1.0 + std::exp(-x));
    default:
      return unit * x;
  }
}

}  // namespace impetus::inline fitting
