// Ten thousand bullets: what only shows now and then.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "tests/engine/shots.hpp"

namespace impetus::tunnelling_long_test {

constexpr std::uint64_t kSeed = 65;

TEST(TunnellingLong, NoBulletOfTenThousandGetsThroughAPlate) {
  for (const std::string& kind : tree_kind_names()) {
    RandomStream random(kSeed, "many bullets/" + kind);
    for (int trial = 0; trial < 1'700; ++trial) {
      // Evenly over the orders of magnitude from .1 to 1e5.
      const double speed =
          std::ldexp(0.1 * (1.0 + random.uniform()), static_cast<int>(random.below(20)));
      World world = shot_at_plate(random, plate(kind, trial % 2 == 0), speed,
                                  handled(Tunnelling::kStopAtEntry), 0.01);
      if (trial % 4 == 0) {
        BodyState& spinning = world.mutable_states()[0];
        spinning.angular_momentum = angular_momentum_at(
            world.models()[0], spinning.pose.orientation,
            std::ldexp(1.0, static_cast<int>(random.below(8)) - 4) * random_direction(random));
      }
      const Shot shot = shoot(world, steps_for(speed));
      ASSERT_EQ(shot.passed, 0) << "seed " << kSeed << ", " << kind << " " << trial << " at "
                                << speed;
    }
  }
}

}  // namespace impetus::tunnelling_long_test
