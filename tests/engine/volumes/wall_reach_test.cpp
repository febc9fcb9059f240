// Spheres beside walls, many at a time: the same answers as one at a time.
// SPDX-License-Identifier: MIT
#include "engine/volumes/enclosure.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/scheduling/viewer.hpp"
#include "tests/engine/builders.hpp"

namespace impetus::wall_reach_test {

constexpr std::uint64_t kSeed = 611;

TEST(WallReach, IsThatOfOneSphereAtATimeEvenWhereItTouchesExactly) {
  RandomStream random(kSeed, "walls");
  const Enclosure walls[] = {ClosedCube{0.4},
                             view_frustum(viewer_at({0.4, 0.3, 1280, 1024, 0.57}, 30.0), 0.2, 0.4)};
  for (const Enclosure& enclosure : walls) {
    const WallReach reaches(enclosure);
    int reaching = 0;
    constexpr int kSpheres = 20'000;
    for (int i = 0; i < kSpheres; ++i) {
      Sphere sphere{random_in_cube(random, 0.3), uniform_in(random, 0.0, 0.2)};
      if (i % 2 == 0) {  // as near to a wall as rounding lets it, to either side
        const int wall = static_cast<int>(random.below(kWallCount));
        sphere.radius_m = std::abs(reach_beyond(enclosure, wall, Sphere{sphere.centre, 0.0}));
      }
      ASSERT_EQ(reaches(sphere), reaches_wall(enclosure, sphere)) << "sphere " << i;
      reaching += reaches(sphere) ? 1 : 0;
    }
    EXPECT_GT(reaching, kSpheres / 20);
    EXPECT_LT(reaching, kSpheres - kSpheres / 20);
  }
}

}  // namespace impetus::wall_reach_test
