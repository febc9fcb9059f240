// How much of the fovea's acuity is left away from it.
//
//   share = e₂ / (e + e₂)     e₂ = 2.3°, at which half is left
//
// (Geisler and Perry 1998: highest visible frequency f_c(e) = e₂ ln(1/CT₀) / (α (e + e₂)), here
// over f_c(0), so neither α nor CT₀ remains)
// SPDX-License-Identifier: MIT
#pragma once

namespace impetus::inline scheduling {

inline constexpr double kHalfAcuity_deg = 2.3;

/// In (0, 1]: 1 where one looks.
inline double relative_acuity(double eccentricity_deg) {
  return kHalfAcuity_deg / (eccentricity_deg + kHalfAcuity_deg);
}

}  // namespace impetus::inline scheduling
