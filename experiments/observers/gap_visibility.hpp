// How large a gap must be to be seen half of the time.
//
//   g₅₀ = at rest · (1 + e/2.3) · (60 / G(v))
//
// SPDX-License-Identifier: MIT
#pragma once

namespace impetus::inline observers {

/// The highest spatial frequency visible at a speed (cycles per degree; Reddy 1997).
double visible_frequency_at(double speed_deg_s);

/// g₅₀ (minutes of arc) at an eccentricity (degrees) and a speed, from what it is at the point of
/// gaze and at rest. It doubles at 2.3° (Geisler and Perry 1998).
double gap_threshold_arcmin(double at_rest_arcmin, double eccentricity_deg, double speed_deg_s);

}  // namespace impetus::inline observers
