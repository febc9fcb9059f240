// Where two bodies that approach along x first touch, for trees of every kind.
// SPDX-License-Identifier: MIT
#include "experiments/run/meeting.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/collision/pair_refinement.hpp"
#include "tests/engine/random_volumes.hpp"

namespace impetus::meeting_test {

constexpr std::uint64_t kSeed = 45;

bool touch_at(const VolumeTree& a, const Pose& pose_a, const VolumeTree& b, const Pose& pose_b) {
  PlacedTree placed_a(a);
  PlacedTree placed_b(b);
  placed_a.move_to(pose_a);
  placed_b.move_to(pose_b);
  return !PairRefinement(placed_a, placed_b, 0).overlapping().empty();
}

TEST(MeetingPlaces, AreWhereAnyTwoVolumesBeginToOverlap) {
  RandomStream random(kSeed, "meeting");
  int met = 0;
  for (int trial = 0; trial < 5'000; ++trial) {
    const auto kind_a = static_cast<int>(random.below(kKinds));
    const auto kind_b = static_cast<int>(random.below(kKinds));
    const VolumeTree a =
        single_node_tree(random_volume(random, kind_a, random_in_cube(random, .4)));
    const VolumeTree b =
        single_node_tree(random_volume(random, kind_b, random_in_cube(random, .4)));
    const Quaternion turn_a = random_turn(random);
    const Quaternion turn_b = random_turn(random);
    const MeetingPlaces places = meeting_places(a, turn_a, b, turn_b, 0);
    const auto overlap_when_moved = [&](double by_m) {
      return touch_at(a, {{places.a_m, 0.0, 0.0}, turn_a}, b,
                      {{places.b_m + by_m, 0.0, 0.0}, turn_b});
    };
    const double aside_m = a.bounding_radius_m() + b.bounding_radius_m();
    if (places.a_m == -a.bounding_radius_m() && places.b_m == b.bounding_radius_m()) {
      for (double by_m = -2.0 * aside_m; by_m < 0.0; by_m += 0.05 * aside_m) {
        ASSERT_FALSE(overlap_when_moved(by_m)) << "seed " << kSeed << ", trial " << trial;
      }
      continue;
    }
    ++met;
    ASSERT_FALSE(overlap_when_moved(1e-7)) << "seed " << kSeed << ", trial " << trial;
    const bool both_flat = content_m3(a.volume(0)) == 0.0 && content_m3(b.volume(0)) == 0.0;
    ASSERT_TRUE(both_flat || overlap_when_moved(-1e-7)) << "seed " << kSeed << ", trial " << trial;
  }
  EXPECT_GT(met, 2'000);
}

TEST(MeetingPlaces, OfTwoBoxesPutTheirFacesAtTheScreensCentre) {
  const VolumeTree wide =
      single_node_tree(Box{Vector3::Zero(), {0.5, 1.0, 1.0}, Quaternion::Identity()});
  const VolumeTree narrow =
      single_node_tree(Box{Vector3::Zero(), {0.25, 1.0, 1.0}, Quaternion::Identity()});
  const MeetingPlaces places =
      meeting_places(wide, Quaternion::Identity(), narrow, Quaternion::Identity(), 0);
  EXPECT_NEAR(places.a_m, -0.5, 1e-11);
  EXPECT_NEAR(places.b_m, 0.25, 1e-11);
}

}  // namespace impetus::meeting_test
