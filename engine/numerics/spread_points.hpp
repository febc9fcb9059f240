// Points spread evenly by a fixed rule, for integrals that come out the same everywhere.
// SPDX-License-Identifier: MIT
#pragma once

namespace impetus::inline numerics {

/// The digits of `index` in base `base`, mirrored behind the point: in [0, 1), spread evenly for
/// any run of indices. Coordinates with different prime bases fill a cube evenly. (Halton 1960)
inline double spread_share(int index, int base) {
  double share = 0.0;
  double unit = 1.0;
  for (; index > 0; index /= base) {
    unit /= base;
    share += unit * (index % base);
  }
  return share;
}

}  // namespace impetus::inline numerics
