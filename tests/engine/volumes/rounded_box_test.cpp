// The common form of volumes: the same points as the kinds themselves.
// SPDX-License-Identifier: MIT
#include "engine/volumes/rounded_box.hpp"

#include <gtest/gtest.h>

#include "tests/engine/one_of_each_kind.hpp"

namespace impetus::rounded_box_test {

constexpr std::uint64_t kSeed = 61;

TEST(RoundedBox, TheSpanOfASegmentHoldsJustThePointsThatTheVolumeHolds) {
  RandomStream random(kSeed, "spans");
  int met = 0;
  int missed = 0;
  for (int trial = 0; trial < 400; ++trial) {
    for (const Volume& volume : one_of_each_kind(random, random_in_cube(random, 0.5), 1.0)) {
      const Vector3 from = random_in_cube(random, 1.5);
      const Vector3 to = random_in_cube(random, 1.5);
      const auto span = span_within(rounded_box(volume), from, to);
      for (int i = 0; i <= 40; ++i) {
        const double share = i / 40.0;
        const bool within = span && span->begin <= share && share <= span->end;
        ASSERT_EQ(holds(volume, from + share * (to - from)), within)
            << "seed " << kSeed << ", trial " << trial << ", kind " << volume.index();
      }
      (span ? met : missed) += 1;
    }
  }
  EXPECT_GT(met, 300);
  EXPECT_GT(missed, 300);
}

TEST(RoundedBox, TheEndsOfASpanLieOnTheSurface) {
  RandomStream random(kSeed, "ends");
  for (int trial = 0; trial < 400; ++trial) {
    for (const Volume& volume : one_of_each_kind(random, Vector3::Zero(), 1.0)) {
      const Vector3 from = 2.5 * random_direction(random);
      const Vector3 to = random_in_cube(random, 0.1);
      const auto span = span_within(rounded_box(volume), from, to);
      ASSERT_TRUE(span);
      EXPECT_FALSE(holds(volume, from + (span->begin - 1e-12) * (to - from)));
      EXPECT_TRUE(holds(volume, from + (span->begin + 1e-12) * (to - from)));
    }
  }
}

TEST(RoundedBox, ASegmentAlongAFaceOrThroughNothingButACornerIsNoSpecialCase) {
  const RoundedBox box = rounded_box(Box{Vector3::Zero(), {1.0, 1.0, 1.0}});
  const auto along = span_within(box, {-2.0, 1.0, 0.0}, {2.0, 1.0, 0.0});
  ASSERT_TRUE(along);
  EXPECT_EQ(along->begin, 0.25);
  EXPECT_EQ(along->end, 0.75);
  EXPECT_FALSE(span_within(box, {-2.0, 1.5, 0.0}, {2.0, 1.5, 0.0}));
  const auto point = span_within(box, {0.5, 0.5, 0.5}, {0.5, 0.5, 0.5});
  ASSERT_TRUE(point) << "a segment of no length";
  const RoundedBox flat = rounded_box(LineSwept{Vector3::Zero(), Vector3::UnitX(), 0.0});
  EXPECT_TRUE(span_within(flat, {0.0, -1.0, 0.0}, {0.0, 1.0, 0.0})) << "through a segment";
}

TEST(RoundedBox, ItsUprightReachIsThatOfItsPoints) {
  RandomStream random(kSeed, "reach");
  for (int trial = 0; trial < 50; ++trial) {
    const Vector3 centre = random_in_cube(random, 1.0);
    for (const Volume& volume : one_of_each_kind(random, centre, 1.0)) {
      const RoundedBox form = rounded_box(volume);
      Vector3 farthest = Vector3::Zero();
      for (int i = 0; i < 2'000; ++i) {
        // The points of most extent: a corner of the core and a step along an axis.
        Vector3 local;
        for (int axis = 0; axis < 3; ++axis) {
          local[axis] = (random.below(2) == 0 ? -1.0 : 1.0) * form.half_extents_m[axis];
        }
        const Vector3 step = Vector3::Unit(static_cast<int>(random.below(3)));
        const Vector3 point = form.placed(local) + form.radius_m * step;
        ASSERT_TRUE(holds(volume, centre + (1.0 - 1e-12) * (point - centre)));
        farthest = farthest.cwiseMax(point - centre);
      }
      EXPECT_LT((farthest - upright_reach_m(form)).norm(), 1e-12);
    }
  }
}

}  // namespace impetus::rounded_box_test
