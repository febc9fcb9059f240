// The integral over the traits in which people differ. Where answers go by a trait smoothly:
// adaptive Gauss–Hermite quadrature, about the place that counts most (Liu and Pierce 1994;
// Pinheiro and Bates 1995). Where they may go by it in steps, as by a threshold that each knows
// exactly: trapezoids, halved until the sum has settled.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "experiments/fitting/minimum.hpp"

namespace impetus::inline fitting {

/// log ∫ exp(f(z)) dz over all z, of a few numbers, where f falls as a parabola does or faster.
/// `highest` is where f is probably highest, and then where it is.
double logarithm_of_integral(const SmoothFunction& f, Eigen::VectorXd& highest);

/// The same of one number, where f may also have steps and several hills.
double logarithm_of_rough_integral(const std::function<double(double)>& f);

/// Newton's method from `at`, which ends where f is highest.
void climb(const SmoothFunction& f, Eigen::VectorXd& at);

}  // namespace impetus::inline fitting
