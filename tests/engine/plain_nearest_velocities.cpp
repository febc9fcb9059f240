// The method of engine/dynamics/nearest_velocities as it reads, which that must equal to the bit.
// SPDX-License-Identifier: MIT
#include "tests/engine/once.hpp"
#include "tests/engine/plain_response.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace impetus::plain {
namespace {

/// What of a unit row must not lie in the span of the active rows for it to count as independent,
/// squared: first finely, and where rounding then leads nowhere, coarsely.
constexpr std::array<double, 2> kIndependent{1e-14, 1e-10};
/// Times the tolerance: what rounding adds to a row that depends on the active ones.
constexpr double kRounding = 300.0;
constexpr int kPolishings = 1;
constexpr std::size_t kStepsPerRow = 8;
constexpr std::size_t kStepsAtLeast = 32;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

double product(const ConstraintRow& row, const std::vector<Vector6>& u) {
  double sum = 0.0;
  for (const RowPart* part : {&row.a, &row.b}) {
    if (part->body >= 0) {
      sum += part->direction.dot(u[static_cast<std::size_t>(part->body)]);
    }
  }
  return sum;
}

double product(const ConstraintRow& x, const ConstraintRow& y) {
  double sum = 0.0;
  for (const RowPart* of_x : {&x.a, &x.b}) {
    for (const RowPart* of_y : {&y.a, &y.b}) {
      if (of_x->body >= 0 && of_x->body == of_y->body) {
        sum += of_x->direction.dot(of_y->direction);
      }
    }
  }
  return sum;
}

void add_to(std::vector<Vector6>& u, const ConstraintRow& row, double times) {
  for (const RowPart* part : {&row.a, &row.b}) {
    if (part->body >= 0) {
      u[static_cast<std::size_t>(part->body)] += times * part->direction;
    }
  }
}

/// The Cholesky factor of the active rows' Gram matrix, by rows, grown and shrunk by one.
class GramFactor {
 public:
  [[nodiscard]] std::size_t size() const { return size_; }

  /// L⁻¹ products: forward substitution.
  [[nodiscard]] std::vector<double> forward(const std::vector<double>& right) const {
    std::vector<double> result(size_);
    for (std::size_t i = 0; i < size_; ++i) {
      double sum = right[i];
      for (std::size_t j = 0; j < i; ++j) {
        sum -= at(i, j) * result[j];
      }
      result[i] = sum / at(i, i);
    }
    return result;
  }

  [[nodiscard]] std::vector<double> backward(std::vector<double> right) const {
    for (std::size_t i = size_; i-- > 0;) {
      for (std::size_t j = i + 1; j < size_; ++j) {
        right[i] -= at(j, i) * right[j];
      }
      right[i] /= at(i, i);
    }
    return right;
  }

  /// `products` are those of the new row with the active ones, forward-substituted; `rest` is what
  /// of its squared length they leave.
  void append(const std::vector<double>& products, double rest) {
    for (const double product : products) {
      entries_.push_back(product);
    }
    entries_.push_back(std::sqrt(rest));
    ++size_;
  }

  void clear() {
    entries_.clear();
    size_ = 0;
  }

 private:
  [[nodiscard]] double at(std::size_t row, std::size_t column) const {
    return entries_[row * (row + 1) / 2 + column];
  }

  std::vector<double> entries_;
  std::size_t size_{0};
};

class ActiveSet {
 public:
  ActiveSet(const std::vector<ConstraintRow>& rows, std::vector<Vector6>& u, double tolerance,
            double independent)
      : given_(u),
        u_(u),
        tolerance_(tolerance),
        independent_(independent),
        multipliers_(rows.size(), 0.0) {
    for (const ConstraintRow& row : rows) {
      const double length = std::sqrt(product(row, row));
      lengths_.push_back(length);
      rows_.push_back(row);
      if (length > 0.0) {
        rows_.back().a.direction /= length;
        rows_.back().b.direction /= length;
        rows_.back().bound /= length;
      }
    }
    is_active_.assign(rows.size(), false);
    is_left_.assign(rows.size(), false);
    steps_left_ = kStepsAtLeast + kStepsPerRow * rows.size();
  }

  NearestVelocities solve() {
    for (std::size_t row = most_violated(); row < rows_.size(); row = most_violated()) {
      if (!satisfy(row)) {
        u_ = given_;
        return {Projection::kGaveUp, std::vector<double>(rows_.size(), 0.0)};
      }
    }
    for (std::size_t row = 0; row < rows_.size(); ++row) {
      multipliers_[row] /= lengths_[row] > 0.0 ? lengths_[row] : 1.0;
    }
    return {Projection::kSolved, multipliers_};
  }

 private:
  [[nodiscard]] std::size_t most_violated() const {
    std::size_t worst = rows_.size();
    double least = -tolerance_;
    for (std::size_t row = 0; row < rows_.size(); ++row) {
      if (!is_active_[row] && !is_left_[row] && lengths_[row] > 0.0) {
        const double slack = product(rows_[row], u_) - rows_[row].bound;
        if (slack < least) {
          least = slack;
          worst = row;
        }
      }
    }
    return worst;
  }

  /// Makes `row` active, letting go of what then pulls.
  bool satisfy(std::size_t row) {
    while (steps_left_-- > 0) {
      std::vector<double> products;
      for (const std::size_t active : active_) {
        products.push_back(product(rows_[active], rows_[row]));
      }
      const std::vector<double> forward = factor_.forward(products);
      double rest = 1.0;
      for (const double entry : forward) {
        rest -= entry * entry;
      }
      const bool independent = rest > independent_;
      const std::vector<double> share = factor_.backward(forward);
      const auto [step_until_pull, pulling] = first_to_pull(share);
      const double slack = product(rows_[row], u_) - rows_[row].bound;
      const double full_step = independent ? std::max(0.0, -slack) / rest : kInfinity;
      const double step = std::min(step_until_pull, full_step);
      if (!(step < kInfinity)) {
        // In the span of the active rows, which satisfy it but for their rounding.
        is_left_[row] = product(rows_[row], u_) - rows_[row].bound >= -kRounding * tolerance_;
        return is_left_[row];
      }
      take(row, step, share);
      if (full_step <= step_until_pull) {
        factor_.append(forward, rest);
        active_.push_back(row);
        is_active_[row] = true;
        polish();
        return true;
      }
      let_go(pulling);
    }
    return false;
  }

  /// The least step at which an active multiplier falls to zero, and which.
  [[nodiscard]] std::pair<double, std::size_t> first_to_pull(
      const std::vector<double>& share) const {
    std::pair<double, std::size_t> first{kInfinity, 0};
    for (std::size_t i = 0; i < active_.size(); ++i) {
      if (share[i] > 0.0) {
        const double step = multipliers_[active_[i]] / share[i];
        if (step < first.first) {
          first = {step, i};
        }
      }
    }
    return first;
  }

  void take(std::size_t row, double step, const std::vector<double>& share) {
    add_to(u_, rows_[row], step);
    multipliers_[row] += step;
    for (std::size_t i = 0; i < active_.size(); ++i) {
      add_to(u_, rows_[active_[i]], -step * share[i]);
      double& multiplier = multipliers_[active_[i]];
      multiplier = std::max(0.0, multiplier - step * share[i]);
    }
  }

  /// Takes from the active rows what rounding has let them drift from their bounds.
  void polish() {
    for (int turn = 0; turn < kPolishings; ++turn) {
      std::vector<double> short_of_bound;
      for (const std::size_t active : active_) {
        short_of_bound.push_back(rows_[active].bound - product(rows_[active], u_));
      }
      const std::vector<double> step = factor_.backward(factor_.forward(short_of_bound));
      for (std::size_t i = 0; i < active_.size(); ++i) {
        double& multiplier = multipliers_[active_[i]];
        const double more = std::max(step[i], -multiplier);
        multiplier += more;
        add_to(u_, rows_[active_[i]], more);
      }
    }
  }

  void let_go(std::size_t which) {
    is_active_[active_[which]] = false;
    multipliers_[active_[which]] = 0.0;
    active_.erase(active_.begin() + static_cast<std::ptrdiff_t>(which));
    factor_.clear();
    std::vector<std::size_t> kept;
    for (const std::size_t row : active_) {
      std::vector<double> products;
      products.reserve(kept.size());
      for (const std::size_t before : kept) {
        products.push_back(product(rows_[before], rows_[row]));
      }
      const std::vector<double> forward = factor_.forward(products);
      double rest = 1.0;
      for (const double entry : forward) {
        rest -= entry * entry;
      }
      factor_.append(forward, std::max(rest, independent_));
      kept.push_back(row);
    }
  }

  std::vector<Vector6> given_;
  std::vector<Vector6>& u_;
  double tolerance_;
  double independent_;
  std::vector<ConstraintRow> rows_;  ///< of unit length
  std::vector<double> lengths_;
  std::vector<double> multipliers_;
  std::vector<std::size_t> active_;
  std::vector<bool> is_active_;
  std::vector<bool> is_left_;  ///< violated by rounding that no step can mend
  GramFactor factor_;
  std::size_t steps_left_;
};

}  // namespace

NearestVelocities project(const std::vector<ConstraintRow>& rows, std::vector<Vector6>& u,
                          double tolerance) {
  NearestVelocities found;
  for (const double independent : kIndependent) {
    found = ActiveSet(rows, u, tolerance, independent).solve();
    if (found.outcome == Projection::kSolved) {
      break;
    }
  }
  return found;
}

}  // namespace impetus::plain
