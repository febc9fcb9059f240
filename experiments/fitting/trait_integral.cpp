// SPDX-License-Identifier: MIT
#include "experiments/fitting/trait_integral.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

namespace impetus::inline fitting {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Nodes and weights for ∫ f(t) exp(−t²) dt.
struct HermiteRule {
  VectorXd nodes;
  VectorXd weights;
};

/// Golub and Welsch 1969: nodes are the eigenvalues of the Hermite polynomials' recurrence.
HermiteRule hermite_rule(Index size) {
  MatrixXd recurrence = MatrixXd::Zero(size, size);
  for (Index i = 1; i < size; ++i) {
    recurrence(i, i - 1) = std::sqrt(0.5 * static_cast<double>(i));
    recurrence(i - 1, i) = recurrence(i, i - 1);
  }
  const Eigen::SelfAdjointEigenSolver<MatrixXd> parts(recurrence);
  return {parts.eigenvalues(),
          std::sqrt(std::numbers::pi) * parts.eigenvectors().row(0).transpose().cwiseAbs2()};
}

const HermiteRule& rule_for(Index traits) {
  static const HermiteRule one = hermite_rule(9);
  static const HermiteRule more = hermite_rule(7);
  return traits <= 1 ? one : more;
}

/// The slope at a place, and the curvature with its sign turned, by differences.
struct Slope {
  VectorXd gradient;
  MatrixXd precision;
};

Slope slope_at(const SmoothFunction& f, const VectorXd& at, double value) {
  constexpr double kStep = 2e-3;
  const Index size = at.size();
  Slope slope{VectorXd(size), MatrixXd(size, size)};
  const auto moved = [&](Index i, double by_i, Index j, double by_j) {
    VectorXd near = at;
    near[i] += by_i;
    near[j] += by_j;
    return f(near);
  };
  for (Index i = 0; i < size; ++i) {
    const double above = moved(i, kStep, i, 0.0);
    const double below = moved(i, -kStep, i, 0.0);
    slope.gradient[i] = (above - below) / (2.0 * kStep);
    slope.precision(i, i) = (2.0 * value - above - below) / (kStep * kStep);
    for (Index j = 0; j < i; ++j) {
      const double twisted = moved(i, kStep, j, kStep) - moved(i, kStep, j, -kStep) -
                             moved(i, -kStep, j, kStep) + moved(i, -kStep, j, -kStep);
      slope.precision(i, j) = -twisted / (4.0 * kStep * kStep);
      slope.precision(j, i) = slope.precision(i, j);
    }
  }
  return slope;
}

/// A place where f is highest.
struct Hilltop {
  double height;
  MatrixXd precision;
};

/// The same as climb().
Hilltop climb_to_top(const SmoothFunction& f, VectorXd& at) {
  constexpr double kClose = 0.1;  // in standard deviations: what is left then is of its square
  constexpr double kShortest = 1e-6;
  constexpr int kMostClimbs = 30;
  Hilltop top{f(at), MatrixXd::Identity(at.size(), at.size())};
  for (int count = 0; count < kMostClimbs; ++count) {
    const Slope slope = slope_at(f, at, top.height);
    top.precision = slope.precision;
    Eigen::LLT<MatrixXd> factor(top.precision);
    if (factor.info() != Eigen::Success) {
      top.precision =
          MatrixXd::Identity(at.size(), at.size()) * (1.0 + top.precision.cwiseAbs().maxCoeff());
      factor.compute(top.precision);
    }
    VectorXd step = factor.solve(slope.gradient);
    const bool is_close = slope.gradient.dot(step) < kClose * kClose;
    double there = f(at + step);
    while (there < top.height && step.norm() > kShortest && !is_close) {
      step *= 0.5;
      there = f(at + step);
    }
    if (there >= top.height) {
      at += step;
      top.height = there;
    }
    if (is_close || !(step.norm() > kShortest)) {
      break;
    }
  }
  return top;
}

/// Values at nodes of a line that are equally far apart, as logarithms.
class NodesOfLine {
 public:
  using Function = std::function<double(double)>;

  /// From 0 outwards, until what lies beyond counts no more.
  explicit NodesOfLine(const Function& f) : f_(f), values_{f(0.0)}, top_(values_[0]) {
    constexpr double kAlways = 6.0;  // in standard deviations over people
    constexpr double kNever = 60.0;
    for (const double side : {-1.0, 1.0}) {
      for (double x = apart_; x < kNever; x += apart_) {
        const double value = at(side * x);
        values_.insert(side < 0.0 ? values_.begin() : values_.end(), value);
        first_ = side < 0.0 ? -x : first_;
        if (x >= kAlways && !counts(value)) {
          break;
        }
      }
    }
  }

  /// One more between any two of which one counts.
  void halve() {
    apart_ *= 0.5;
    std::vector<double> all{values_[0]};
    for (std::size_t i = 1; i < values_.size(); ++i) {
      const double middle = first_ + apart_ * (2.0 * static_cast<double>(i) - 1.0);
      const bool is_near = counts(values_[i - 1]) || counts(values_[i]);
      all.push_back(is_near ? at(middle) : kNothing);
      all.push_back(values_[i]);
    }
    values_ = std::move(all);
  }

  [[nodiscard]] double apart() const { return apart_; }
  /// The logarithm of the trapezoids' sum.
  [[nodiscard]] double logarithm() const {
    double sum = 0.0;
    for (const double value : values_) {
      sum += std::exp(value - top_);
    }
    return top_ + std::log(sum * apart_);
  }

  /// The same with trapezoids that are halved where they have not settled, and there alone.
  [[nodiscard]] double logarithm_where_rough() {
    const double base = top_;
    const double settled = kSettledLocally * std::exp(logarithm() - base);
    double sum = 0.0;
    for (std::size_t i = 1; i < values_.size(); ++i) {
      const double from = first_ + apart_ * static_cast<double>(i - 1);
      if (counts(values_[i - 1]) || counts(values_[i])) {
        sum += between({from, std::exp(values_[i - 1] - base)},
                       {from + apart_, std::exp(values_[i] - base)}, base, settled);
      }
    }
    return base + std::log(sum);
  }

 private:
  static constexpr double kNothing = -std::numeric_limits<double>::infinity();
  static constexpr double kSettledLocally = 1e-4;
  static constexpr double kLeastApart = 1e-4;
  /// The integrand at a place.
  struct Node {
    double x;
    double height;  ///< not its logarithm
  };

  double at(double x) {
    const double value = f_(x);
    top_ = std::max(top_, value);
    return value;
  }
  [[nodiscard]] bool counts(double value) const { return value > top_ - 16.0; }

  /// The area from one to the other, halved as long as that changes it by more than `settled`.
  double between(const Node& a, const Node& b, double base, double settled) {
    const Node middle{0.5 * (a.x + b.x), std::exp(at(0.5 * (a.x + b.x)) - base)};
    const double whole = 0.5 * (b.x - a.x) * (a.height + b.height);
    const double halves = 0.5 * whole + 0.5 * (b.x - a.x) * middle.height;
    if (std::abs(halves - whole) < settled || b.x - a.x < kLeastApart) {
      return halves;
    }
    return between(a, middle, base, settled) + between(middle, b, base, settled);
  }

  const Function& f_;
  double apart_{1.0};
  double first_{0.0};
  std::vector<double> values_;
  double top_;
};

/// The next node of a grid of rules, one for each trait; false: it was the last.
bool go_on(std::vector<Index>& node, Index nodes) {
  for (Index& digit : node) {
    if (++digit < nodes) {
      return true;
    }
    digit = 0;
  }
  return false;
}

}  // namespace

void climb(const SmoothFunction& f, VectorXd& at) { static_cast<void>(climb_to_top(f, at)); }

double logarithm_of_integral(const SmoothFunction& f, VectorXd& highest) {
  const Index size = highest.size();
  const auto [top, precision] = climb_to_top(f, highest);
  // z = highest + √2 L t with L Lᵀ the inverse of the precision.
  const MatrixXd lower = Eigen::LLT<MatrixXd>(precision.inverse()).matrixL();
  const HermiteRule& rule = rule_for(size);
  double sum = 0.0;
  std::vector<Index> node(static_cast<std::size_t>(size), 0);
  do {
    VectorXd t(size);
    double weight = 1.0;
    for (Index i = 0; i < size; ++i) {
      t[i] = rule.nodes[node[static_cast<std::size_t>(i)]];
      weight *= rule.weights[node[static_cast<std::size_t>(i)]];
    }
    const double at = f(highest + std::numbers::sqrt2 * (lower * t));
    sum += weight * std::exp(at - top + t.squaredNorm());
  } while (go_on(node, rule.nodes.size()));
  // |√2 L| of the change of variables
  const double scale =
      0.5 * static_cast<double>(size) * std::log(2.0) + lower.diagonal().array().log().sum();
  return top + std::log(sum) + scale;
}

double logarithm_of_rough_integral(const std::function<double(double)>& f) {
  constexpr double kSettled = 5e-4;
  constexpr double kLeastApart = 1.0 / 8.0;
  NodesOfLine nodes(f);
  double before = nodes.logarithm();
  double moved_before = 0.0;
  while (nodes.apart() > kLeastApart) {
    nodes.halve();
    const double now = nodes.logarithm();
    // Of smooth functions each change is far less than the one before, of steps about half of it.
    const double moved = std::abs(now - before);
    const double next = moved_before > moved ? moved * moved / moved_before : moved;
    if (next < kSettled) {
      return now;
    }
    before = now;
    moved_before = moved;
  }
  return nodes.logarithm_where_rough();
}

}  // namespace impetus::inline fitting
