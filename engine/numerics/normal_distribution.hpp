// The normal distribution function made of + − × ÷ alone: the same bits on every machine.
// SPDX-License-Identifier: MIT
#pragma once

namespace impetus::inline numerics {

/// Φ(z), the share of a standard normal distribution below z; relative error below 4e-15, in the
/// lower tail too, as far down as −37.
double cumulative_normal(double z);

}  // namespace impetus::inline numerics
