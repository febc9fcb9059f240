// Logarithms made of + − × ÷ alone: the same bits on every machine.
//
// The C library's differ between versions in the last bit, so nothing that decides a step may use
// them.
// SPDX-License-Identifier: MIT
#pragma once

namespace impetus::inline numerics {

/// log₁₀ of a positive number, error below 1e-15 of the larger of 1 and the result; −∞ of zero,
/// not a number of a negative one.
double log10_of(double x);

/// Natural logarithm of a positive number, relative error below 1e-15; −∞ of zero, not a number of
/// a negative one.
double log_of(double x);

}  // namespace impetus::inline numerics
