// Random draws of the shapes that observers need, from a named stream.
//
// An observer may use the library's functions: what it answers is recorded, not computed again.
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/numerics/random_stream.hpp"

namespace impetus::inline observers {

/// Mean 0, standard deviation 1.
double draw_normal(RandomStream& stream);

/// Uniform in [least, most).
double draw_between(RandomStream& stream, double least, double most);

/// Lognormal: `sigma_log` is the standard deviation of the natural logarithm.
double draw_lognormal(RandomStream& stream, double median, double sigma_log);

/// Waiting time of a Poisson process (the rate's inverse unit); infinite at rate 0.
double draw_waiting(RandomStream& stream, double rate);

/// Φ, the standard normal distribution function.
double normal_cdf(double z);

}  // namespace impetus::inline observers
