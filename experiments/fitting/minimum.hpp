// The minimum of a smooth function of several numbers.
//
// Broyden, Fletcher, Goldfarb and Shanno's method with gradients by central differences: each step
// goes to the minimum of a parabola, whose curvature is learnt from the gradients on the way.
// (Nocedal and Wright 2006, algorithm 6.1)
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <functional>

namespace impetus::inline fitting {

/// Where a function is not defined it is infinite.
using SmoothFunction = std::function<double(const Eigen::VectorXd&)>;

/// Where a search ended.
struct FoundMinimum {
  Eigen::VectorXd at;
  double value{0.0};
};

/// The minimum that is downhill from `start`, to a fall of `tolerance` that is still expected.
/// `inverse_curvature`: a guess of the inverse Hessian; of no rows: the identity. After
/// `most_steps` it is wherever it came to.
FoundMinimum find_minimum(const SmoothFunction& function, const Eigen::VectorXd& start,
                          double tolerance, const Eigen::MatrixXd& inverse_curvature = {},
                          int most_steps = 200);

/// The second derivatives at a place, by differences.
Eigen::MatrixXd curvature_at(const SmoothFunction& function, const Eigen::VectorXd& at);

/// The inverse of a Hessian, where what is flat or falls is taken for a little curved.
Eigen::MatrixXd inverse_of_curvature(const Eigen::MatrixXd& curvature);

}  // namespace impetus::inline fitting
