// SPDX-License-Identifier: MIT
#include "engine/dynamics/nearest_velocities.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace impetus::inline dynamics {
namespace {

/// What of a unit row must not lie in the span of the active rows for it to count as independent,
/// squared: first finely, and where rounding then leads nowhere, coarsely.
constexpr std::array<double, 2> kIndependent{1e-14, 1e-10};
/// Times the tolerance: what rounding adds to a row that depends on the active ones.
constexpr double kRoundings = 300.0;
constexpr int kPolishings = 1;
constexpr std::size_t kStepsPerRow = 8;
constexpr std::size_t kStepsAtLeast = 32;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

double rest_of(const std::vector<double>& forward) {
  double rest = 1.0;
  for (const double entry : forward) {
    rest -= entry * entry;
  }
  return rest;
}

}  // namespace

Projection NearestVelocitySolver::solve(const UnitRows& given,
                                        const std::vector<std::size_t>& which,
                                        std::vector<Vector6>& u, double tolerance) {
  tolerance_ = tolerance;
  rows_ = &given.rows;
  bounds_.resize(rows_->size());
  for (const std::size_t row : which) {
    const double length = given.lengths[row];
    bounds_[row] = length > 0.0 ? given.bounds[row] / length : given.bounds[row];
  }
  given_.assign(u.begin(), u.end());
  for (const double independent : kIndependent) {
    independent_ = independent;
    if (solve_active_set(given, which, u)) {
      return Projection::kSolved;
    }
    u.assign(given_.begin(), given_.end());
  }
  multipliers_.assign(rows_->size(), 0.0);
  return Projection::kGaveUp;
}

bool NearestVelocitySolver::solve_active_set(const UnitRows& given,
                                             const std::vector<std::size_t>& which,
                                             std::vector<Vector6>& u) {
  active_.clear();
  active_rows_.clear();
  factor_.shrink(0);
  multipliers_.assign(rows_->size(), 0.0);
  is_out_.assign(rows_->size(), 1);
  for (const std::size_t row : which) {
    is_out_[row] = given.lengths[row] > 0.0 ? 0 : 1;
  }
  steps_left_ = kStepsAtLeast + kStepsPerRow * which.size();
  for (std::size_t row = most_violated(u); row < rows_->size(); row = most_violated(u)) {
    if (!satisfy(row, u)) {
      return false;
    }
  }
  for (const std::size_t row : which) {
    multipliers_[row] /= given.lengths[row] > 0.0 ? given.lengths[row] : 1.0;
  }
  return true;
}

std::size_t NearestVelocitySolver::most_violated(const std::vector<Vector6>& u) {
  rows_->find_products(u, products_with_u_);
  std::size_t worst = rows_->size();
  double least = -tolerance_;
  for (std::size_t row = 0; row < products_with_u_.size(); ++row) {
    const double slack = products_with_u_[row] - bounds_[row];
    if (slack < least && is_out_[row] == 0) {
      least = slack;
      worst = row;
    }
  }
  return worst;
}

void NearestVelocitySolver::multiply_by_active(const ConstraintRow& row) {
  products_.clear();
  for (const ConstraintRow& active : active_rows_) {
    products_.push_back(dot(active, row));
  }
}

/// Makes a row active, letting go of what then pulls.
bool NearestVelocitySolver::satisfy(std::size_t index, std::vector<Vector6>& u) {
  const ConstraintRow row = rows_->row(index);
  multiply_by_active(row);
  while (steps_left_-- > 0) {
    forward_.assign(products_.begin(), products_.end());
    factor_.forward(forward_);
    const double rest = rest_of(forward_);
    const bool independent = rest > independent_;
    share_.assign(forward_.begin(), forward_.end());
    factor_.backward(share_);
    const auto [step_until_pull, pulling] = first_to_pull();
    const double slack = dot(row, u) - bounds_[index];
    const double full_step = independent ? std::max(0.0, -slack) / rest : kInfinity;
    const double step = std::min(step_until_pull, full_step);
    if (!(step < kInfinity)) {
      // In the span of the active rows, which satisfy it but for their rounding.
      const bool is_left = slack >= -kRoundings * tolerance_;
      is_out_[index] = is_left ? 1 : 0;
      return is_left;
    }
    multipliers_[index] += step;
    take(row, step, u);
    if (full_step <= step_until_pull) {
      factor_.append(forward_, rest);
      active_.push_back(index);
      active_rows_.push_back(row);
      is_out_[index] = 1;
      polish(u);
      return true;
    }
    products_.erase(products_.begin() + static_cast<std::ptrdiff_t>(pulling));
    let_go(pulling);
  }
  return false;
}

/// The least step at which an active multiplier falls to zero, and which.
std::pair<double, std::size_t> NearestVelocitySolver::first_to_pull() const {
  std::pair<double, std::size_t> first{kInfinity, 0};
  for (std::size_t i = 0; i < active_.size(); ++i) {
    if (share_[i] > 0.0) {
      const double step = multipliers_[active_[i]] / share_[i];
      if (step < first.first) {
        first = {step, i};
      }
    }
  }
  return first;
}

void NearestVelocitySolver::take(const ConstraintRow& row, double step, std::vector<Vector6>& u) {
  add(u, row, step);
  for (std::size_t i = 0; i < active_.size(); ++i) {
    add(u, active_rows_[i], -step * share_[i]);
    double& multiplier = multipliers_[active_[i]];
    multiplier = std::max(0.0, multiplier - step * share_[i]);
  }
}

/// Takes from the active rows what rounding has let them drift from their bounds.
void NearestVelocitySolver::polish(std::vector<Vector6>& u) {
  for (int turn = 0; turn < kPolishings; ++turn) {
    share_.clear();
    for (std::size_t i = 0; i < active_.size(); ++i) {
      share_.push_back(bounds_[active_[i]] - dot(active_rows_[i], u));
    }
    factor_.forward(share_);
    factor_.backward(share_);
    for (std::size_t i = 0; i < active_.size(); ++i) {
      double& multiplier = multipliers_[active_[i]];
      const double more = std::max(share_[i], -multiplier);
      multiplier += more;
      add(u, active_rows_[i], more);
    }
  }
}

/// The factor's rows before `which` stay; of those after it, the products with those before.
void NearestVelocitySolver::let_go(std::size_t which) {
  is_out_[active_[which]] = 0;
  multipliers_[active_[which]] = 0.0;
  active_.erase(active_.begin() + static_cast<std::ptrdiff_t>(which));
  active_rows_.erase(active_rows_.begin() + static_cast<std::ptrdiff_t>(which));
  factor_.shrink(which);
  for (std::size_t row = which; row < active_.size(); ++row) {
    forward_.clear();
    for (std::size_t before = 0; before < row; ++before) {
      forward_.push_back(before < which ? factor_.at(row + 1, before)
                                        : dot(active_rows_[before], active_rows_[row]));
    }
    factor_.forward(forward_, which);
    factor_.append(forward_, std::max(rest_of(forward_), independent_));
  }
}

}  // namespace impetus::inline dynamics
