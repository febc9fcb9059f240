// SPDX-License-Identifier: MIT
#include "experiments/design/staircase.hpp"

#include <algorithm>

namespace impetus::inline design {
namespace {

double power(double base, std::int64_t exponent) {
  double product = 1.0;
  for (std::int64_t factor = 0; factor < exponent; ++factor) {
    product *= base;
  }
  return product;
}

/// Chance that `down` positives in a row, each of chance p, come before `up` negatives in a row.
double chance_of_going_down(const Staircase& rule, double p) {
  const double q = 1.0 - p;
  const double almost_down = power(p, rule.down - 1);
  const double almost_up = power(q, rule.up - 1);
  return almost_down * (1.0 - power(q, rule.up)) /
         (almost_down + almost_up - almost_down * almost_up);
}

}  // namespace

void StaircaseTrack::answer(bool positive) {
  positives_ = positive ? positives_ + 1 : 0;
  negatives_ = positive ? 0 : negatives_ + 1;
  if (positives_ >= rule_.down) {
    move(Direction::kHarder);
  } else if (negatives_ >= rule_.up) {
    move(Direction::kEasier);
  }
}

void StaircaseTrack::move(Direction direction) {
  if (direction_ != Direction::kNone && direction_ != direction) {
    ++reversals_;
  }
  direction_ = direction;
  const std::int64_t wanted = direction == Direction::kHarder ? level_ - step() : level_ + step();
  level_ = std::clamp(wanted, std::int64_t{0}, last_level_);
  positives_ = negatives_ = 0;
}

std::int64_t StaircaseTrack::step() const {
  const auto last = static_cast<std::int64_t>(rule_.steps.size()) - 1;
  return rule_.steps[static_cast<std::size_t>(std::min(reversals_, last))];
}

std::vector<FactorLevel> StaircaseTrack::state() const {
  const char* direction = direction_ == Direction::kHarder   ? "harder"
                          : direction_ == Direction::kEasier ? "easier"
                                                             : "none";
  return {{"reversals", static_cast<double>(reversals_)},
          {"step", static_cast<double>(step())},
          {"positives_in_a_row", static_cast<double>(positives_)},
          {"negatives_in_a_row", static_cast<double>(negatives_)},
          {"direction", std::string(direction)}};
}

double settling_share(const Staircase& rule) {
  double low = 0.0;
  double high = 1.0;
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = 0.5 * (low + high);
    (chance_of_going_down(rule, middle) < 0.5 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace impetus::inline design
