// SPDX-License-Identifier: MIT
#include "experiments/fitting/minimum.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace impetus::inline fitting {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kGradientStep = 1e-4;
constexpr double kCurvatureStep = 3e-3;
constexpr double kLongestStep = 2.0;  ///< of any one number

constexpr double kCoarse = 1e-3;  ///< a tolerance that one side of a slope is enough for

/// From one side alone where that is enough, or the function is not defined on the other. `value`
/// is that at `at`.
VectorXd gradient_at(const SmoothFunction& function, const VectorXd& at, double value,
                     bool is_coarse) {
  VectorXd gradient(at.size());
  VectorXd near = at;
  for (Eigen::Index i = 0; i < at.size(); ++i) {
    near[i] = at[i] + kGradientStep;
    const double rise = (function(near) - value) / kGradientStep;
    if (is_coarse && std::isfinite(rise)) {
      gradient[i] = rise;
    } else {
      near[i] = at[i] - kGradientStep;
      const double before = (value - function(near)) / kGradientStep;
      gradient[i] = !std::isfinite(rise)     ? before
                    : !std::isfinite(before) ? rise
                                             : 0.5 * (before + rise);
    }
    near[i] = at[i];
  }
  return gradient;
}

/// The update of the inverse Hessian by what the last step taught.
void learn(const VectorXd& step, const VectorXd& change, MatrixXd& inverse) {
  const double along = step.dot(change);
  if (along <= 1e-10 * step.norm() * change.norm()) {
    return;  // not convex here: nothing to be learnt
  }
  const MatrixXd identity = MatrixXd::Identity(step.size(), step.size());
  const MatrixXd left = identity - step * change.transpose() / along;
  inverse = left * inverse * left.transpose() + step * step.transpose() / along;
}

}  // namespace

FoundMinimum find_minimum(const SmoothFunction& function, const VectorXd& start, double tolerance,
                          const MatrixXd& inverse_curvature, int most_steps) {
  FoundMinimum found{start, function(start)};
  if (start.size() == 0) {
    return found;
  }
  const MatrixXd identity = MatrixXd::Identity(start.size(), start.size());
  const bool is_coarse = tolerance >= kCoarse;
  bool is_fresh = inverse_curvature.rows() == 0;
  MatrixXd inverse = is_fresh ? identity : inverse_curvature;
  VectorXd gradient = gradient_at(function, found.at, found.value, is_coarse);
  for (int count = 0; count < most_steps && gradient.allFinite(); ++count) {
    VectorXd step = -(inverse * gradient);
    double fall = -gradient.dot(step);
    if (fall <= 0.0) {
      inverse = identity;
      step = -gradient;
      fall = gradient.squaredNorm();
    }
    if (0.5 * fall < tolerance) {
      return found;
    }
    const double longest = step.cwiseAbs().maxCoeff();
    double share = std::min(1.0, kLongestStep / longest);
    double value = function(found.at + share * step);
    // Halved until it falls by a tenth of a thousandth of what the slope promises (Armijo).
    while (!(value <= found.value - 1e-4 * share * fall) && share * longest > 1e-9) {
      share *= 0.5;
      value = function(found.at + share * step);
    }
    if (!(value < found.value)) {
      if (is_fresh) {
        return found;
      }
      inverse = identity;  // what was learnt misleads: once more from the slope alone
      is_fresh = true;
      continue;
    }
    is_fresh = false;
    const VectorXd moved = share * step;
    found = {found.at + moved, value};
    const VectorXd there = gradient_at(function, found.at, found.value, is_coarse);
    learn(moved, there - gradient, inverse);
    gradient = there;
  }
  return found;
}

MatrixXd curvature_at(const SmoothFunction& function, const VectorXd& at) {
  const Eigen::Index size = at.size();
  const double h = kCurvatureStep;
  const double centre = function(at);
  const auto moved = [&](Eigen::Index i, double by_i, Eigen::Index j, double by_j) {
    VectorXd near = at;
    near[i] += by_i;
    near[j] += by_j;
    return function(near);
  };
  MatrixXd curvature(size, size);
  for (Eigen::Index i = 0; i < size; ++i) {
    curvature(i, i) = (moved(i, h, i, 0.0) - 2.0 * centre + moved(i, -h, i, 0.0)) / (h * h);
    for (Eigen::Index j = 0; j < i; ++j) {
      curvature(i, j) =
          (moved(i, h, j, h) - moved(i, h, j, -h) - moved(i, -h, j, h) + moved(i, -h, j, -h)) /
          (4.0 * h * h);
      curvature(j, i) = curvature(i, j);
    }
  }
  return curvature;
}

MatrixXd inverse_of_curvature(const MatrixXd& curvature) {
  constexpr double kFlat = 0.05;
  if (curvature.size() == 0 || !curvature.allFinite()) {
    return MatrixXd::Identity(curvature.rows(), curvature.cols());
  }
  const Eigen::SelfAdjointEigenSolver<MatrixXd> parts(curvature);
  const VectorXd inverse = parts.eigenvalues().cwiseMax(kFlat).cwiseInverse();
  return parts.eigenvectors() * inverse.asDiagonal() * parts.eigenvectors().transpose();
}

}  // namespace impetus::inline fitting
