// A figure that tumbles freely for a hundred thousand steps.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "tests/engine/figure_flight.hpp"

namespace impetus::figure_tumble_test {

TEST(FigureTumble, MomentumIsKeptToRoundingHingesAndEnergyWithinStatedNumbers) {
  const Flight flight = fly(100'000, 0.02, Rotation::kMidpoint);
  EXPECT_LT(flight.momentum_drift, 1e-12);
  EXPECT_LT(flight.angular_drift, 1e-11);
  EXPECT_LT(flight.energy_drift, 1e-9);
  EXPECT_LT(flight.widest_gap_m, 1e-10);
}

}  // namespace impetus::figure_tumble_test
