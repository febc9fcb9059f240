// The integral over the traits in which people differ: adaptive Gauss–Hermite quadrature, about the
// place that counts most (Liu and Pierce 1994; Pinheiro and Bates 1995).
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/fitting/minimum.hpp"

namespace impetus::inline fitting {

/// log ∫ exp(f(z)) dz over all z, of a few numbers, where f falls as a parabola does or faster.
/// `highest` is where f is probably highest, and then where it is.
double logarithm_of_integral(const SmoothFunction& f, Eigen::VectorXd& highest);

}  // namespace impetus::inline fitting
