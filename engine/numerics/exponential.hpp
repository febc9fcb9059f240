// The exponential function made of + − × ÷ alone: the same bits on every machine.
// SPDX-License-Identifier: MIT
#pragma once

namespace impetus::inline numerics {

/// e^x, relative error below 1e-15 where the result is a normal number; 0 and ∞ beyond the range.
double exp_of(double x);

}  // namespace impetus::inline numerics
