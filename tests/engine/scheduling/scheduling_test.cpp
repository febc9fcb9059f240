// Scheduling: where the eye is, who comes first, and what a meter grants.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "engine/scheduling/metrics.hpp"
#include "engine/scheduling/priority_lists.hpp"
#include "engine/scheduling/viewer.hpp"
#include "engine/scheduling/work_meter.hpp"
#include "tests/engine/builders.hpp"
#include "tests/engine/scheduled_pairs.hpp"

namespace impetus::scheduling_test {

constexpr ScreenGeometry kScreen{0.5, 0.3, 1600, 900, 0.57};

PairBounds pair_at(std::int32_t a, std::int32_t b, const Vector3& place) {
  return {{a, b}, {place - Vector3::UnitX(), 1.0}, {place + Vector3::UnitX(), 1.0}};
}

TEST(Viewer, WithoutAzimuthLooksAlongMinusZ) {
  const Viewer viewer = viewer_at(kScreen, 0.0);
  EXPECT_EQ(viewer.eye, Vector3(0.0, 0.0, 0.57));
  EXPECT_EQ(viewer.right, Vector3::UnitX());
  EXPECT_EQ(viewer.up, Vector3::UnitY());
}

TEST(Viewer, AQuarterTurnLooksAlongMinusXExactly) {
  const Viewer viewer = viewer_at(kScreen, 90.0);
  EXPECT_EQ(viewer.eye, Vector3(0.57, 0.0, 0.0));
  EXPECT_EQ(viewer.right, Vector3(0.0, 0.0, -1.0));
}

TEST(Viewer, AnyAzimuthFacesTheOriginWithARightHandedFrame) {
  for (double azimuth_deg = -180.0; azimuth_deg <= 180.0; azimuth_deg += 7.5) {
    const Viewer viewer = viewer_at(kScreen, azimuth_deg);
    // Two roundings of sine and cosine.
    EXPECT_NEAR(viewer.eye.norm(), 0.57, 1e-15);
    EXPECT_LT((viewer.right.cross(viewer.up) - viewer.eye / 0.57).norm(), 1e-15) << azimuth_deg;
  }
}

std::vector<BodyPair> order_of(const std::vector<PairBounds>& bounds, const Viewer& viewer) {
  std::vector<BodyPair> order;
  for (const ScheduledPair& entry : scheduled(bounds, {}, viewer, {}, {})) {
    EXPECT_EQ(entry.list, 0);
    order.push_back(entry.pair);
  }
  return order;
}

TEST(Schedule, AsItStandsTakesNearPairsFirst) {
  Viewer viewer;
  viewer.eye = Vector3(0.0, 0.0, 10.0);
  EXPECT_EQ(order_of({pair_at(0, 1, {0.0, 0.0, -5.0}), pair_at(0, 2, {0.0, 0.0, 5.0}),
                      pair_at(1, 2, {0.0, 3.0, 0.0})},
                     viewer),
            (std::vector<BodyPair>{{0, 2}, {1, 2}, {0, 1}}));
}

TEST(Schedule, EqualPrioritiesKeepTheirOrder) {
  std::vector<PairBounds> bounds;
  std::vector<BodyPair> expected;
  for (std::int32_t i = 0; i < 40; ++i) {
    bounds.push_back(pair_at(i, i + 1, Vector3::Zero()));
    expected.push_back({i, i + 1});
  }
  EXPECT_EQ(order_of(bounds, Viewer{}), expected);
}

TEST(FixedWork, GrantsUpToItsNumberInEveryStep) {
  FixedWork meter(10);
  EXPECT_EQ(meter.request(WorkPhase::kRefinement, 4, 0), 4);
  EXPECT_EQ(meter.request(WorkPhase::kRefinement, 10, 0), 10);
  EXPECT_EQ(meter.request(WorkPhase::kRefinement, 11, 0), 10) << "refused";
  EXPECT_EQ(meter.request(WorkPhase::kRefinement, 7, 0), 7) << "the next step starts anew";
}

}  // namespace impetus::scheduling_test
