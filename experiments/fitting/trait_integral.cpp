// SPDX-License-Identifier: MIT
#include "experiments/fitting/trait_integral.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>
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

/// Newton's method from `at`, which ends where f is highest; returns the precision there.
MatrixXd climb(const SmoothFunction& f, VectorXd& at) {
  constexpr double kClose = 1e-4;  // in standard deviations over people: the quadrature forgives
  constexpr int kMostClimbs = 30;
  MatrixXd precision = MatrixXd::Identity(at.size(), at.size());
  double value = f(at);
  for (int count = 0; count < kMostClimbs; ++count) {
    const Slope slope = slope_at(f, at, value);
    precision = slope.precision;
    Eigen::LLT<MatrixXd> factor(precision);
    if (factor.info() != Eigen::Success) {
      precision =
          MatrixXd::Identity(at.size(), at.size()) * (1.0 + precision.cwiseAbs().maxCoeff());
      factor.compute(precision);
    }
    VectorXd step = factor.solve(slope.gradient);
    if (step.norm() < kClose) {
      break;
    }
    double there = f(at + step);
    while (there < value && step.norm() > 0.01 * kClose) {
      step *= 0.5;
      there = f(at + step);
    }
    if (!std::isfinite(there)) {
      break;
    }
    at += step;
    value = there;
  }
  return precision;
}

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

double logarithm_of_integral(const SmoothFunction& f, VectorXd& highest) {
  const Index size = highest.size();
  const MatrixXd precision = climb(f, highest);
  // z = highest + √2 L t with L Lᵀ the inverse of the precision.
  const MatrixXd lower = Eigen::LLT<MatrixXd>(precision.inverse()).matrixL();
  const HermiteRule& rule = rule_for(size);
  const double top = f(highest);
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

}  // namespace impetus::inline fitting
