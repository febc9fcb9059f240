// Sine, cosine, arc tangent, logarithms, exponential, cube root and the normal distribution made of
// + − × ÷ alone: the same bits on every machine.
//
// The C library's functions differ between versions in the last bit, so nothing that decides a
// step may use them.
// SPDX-License-Identifier: MIT
#pragma once

namespace impetus::inline numerics {

inline constexpr double kRadiansPerDegree = 0.017453292519943295;
inline constexpr double kDegreesPerRadian = 57.29577951308232;

/// Both of one angle.
struct SineCosine {
  double sine;
  double cosine;
};

/// Sine and cosine of an angle in degrees, |angle| ≤ 1e6; error below 2e-16. Multiples of 90° are
/// exact.
SineCosine sine_cosine_deg(double angle_deg);

/// The angle of the point (x, y) from the x axis (radians), in [−π, π]; error below 1e-15. Both
/// zero gives zero; a value that is not finite may give a result that is not a number.
double atan2_rad(double y, double x);

double degrees(double angle_rad);

/// Metres in the screen's plane that one degree of visual angle covers at its centre, for an eye
/// `viewing_distance_m` away: 2 d tan(½°). Used as a linear scale, so 10° is ten times 1°.
double metres_per_degree(double viewing_distance_m);

/// e^x, relative error below 1e-15 where the result is a normal number; 0 and ∞ beyond the range.
double exp_of(double x);

/// log₁₀ of a positive number, error below 1e-15 of the larger of 1 and the result; −∞ of zero,
/// not a number of a negative one.
double log10_of(double x);

/// Natural logarithm of a positive number, relative error below 1e-15; −∞ of zero, not a number of
/// a negative one.
double log_of(double x);

/// Of a positive number, to within an ulp or two. (Newton's iteration)
double cube_root(double x);

/// Φ(z), the share of a standard normal distribution below z; relative error below 4e-15, in the
/// lower tail too, as far down as −37.
double cumulative_normal(double z);

}  // namespace impetus::inline numerics
