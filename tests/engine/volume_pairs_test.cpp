// Every pair of kinds of volume: overlap against a search for the least distance and against
// sampled points, contact against what moving the volumes apart shows.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/engine/random_volumes.hpp"

namespace impetus::volume_pairs_test {

constexpr std::uint64_t kSeed = 41;
constexpr int kPairsOfVolumes = 3'000;

/// What is known of a distance.
struct Bounds {
  double least_m;
  double most_m;
};

/// The oracle: the least distance between two cores by moving weights among the differences of
/// their corners (Mitchell, Demyanov and Malozemov 1974). It knows nothing of axes, edges or faces.
Bounds searched_distance(const Corners& a, const Corners& b) {
  std::vector<Vector3> differences;
  for (const Vector3& of_a : a.places) {
    for (const Vector3& of_b : b.places) {
      differences.push_back(of_a - of_b);
    }
  }
  std::vector<double> weights(differences.size(), 0.0);
  weights[0] = 1.0;
  Vector3 nearest = differences[0];
  double least_m = 0.0;
  for (int round = 0; round < 3'000; ++round) {
    std::size_t best = 0;
    std::size_t worst = differences.size();
    for (std::size_t i = 0; i < differences.size(); ++i) {
      const double along = differences[i].dot(nearest);
      best = along < differences[best].dot(nearest) ? i : best;
      if (weights[i] > 0.0 &&
          (worst == differences.size() || along > differences[worst].dot(nearest))) {
        worst = i;
      }
    }
    least_m = std::max(least_m, differences[best].dot(nearest) / nearest.norm());
    const Vector3 way = differences[best] - differences[worst];
    if (!(-way.dot(nearest) > 1e-14)) {
      break;
    }
    const double step = std::min(-way.dot(nearest) / way.squaredNorm(), weights[worst]);
    weights[worst] = step < weights[worst] ? weights[worst] - step : 0.0;
    weights[best] += step;
    nearest += step * way;
  }
  return {least_m, nearest.norm()};
}

bool same_bits(const TouchPoint& x, const TouchPoint& y) {
  return x.point == y.point && x.normal == y.normal && x.depth_m == y.depth_m;
}

/// A random point of the volume.
Vector3 point_within(RandomStream& random, const Volume& volume) {
  const Corners corners = corners_of(volume);
  const Vector3& origin = corners.places[0];
  Vector3 place = origin;
  for (const std::size_t next : {1U, 2U, 4U}) {
    place += random.uniform() * (corners.places[next] - origin);
  }
  return place + corners.radius_m * random.uniform() * random_direction(random);
}

Sphere grown(Sphere sphere, double by_m) { return {sphere.centre, sphere.radius_m + by_m}; }
LineSwept grown(LineSwept line, double by_m) {
  line.radius_m += by_m;
  return line;
}
RectangleSwept grown(RectangleSwept rectangle, double by_m) {
  rectangle.radius_m += by_m;
  return rectangle;
}
Box grown(Box box, double by_m) {
  box.half_extents_m.array() += by_m;
  return box;
}
Cube grown(Cube cube, double by_m) {
  cube.half_edge_m += by_m;
  return cube;
}

bool nearly_holds(const Volume& volume, const Vector3& point) {
  return std::visit([&](const auto& kind) { return holds(grown(kind, 1e-9), point); }, volume);
}

bool has_cube(const Volume& a, const Volume& b) {
  return std::holds_alternative<Cube>(a) || std::holds_alternative<Cube>(b);
}

struct Pair {
  Volume a;
  Volume b;
};

class EveryPair : public ::testing::TestWithParam<std::pair<int, int>> {
 protected:
  EveryPair()
      : random_(kSeed, std::string(kKindNames[static_cast<std::size_t>(GetParam().first)]) +
                           kKindNames[static_cast<std::size_t>(GetParam().second)]) {
    RecordProperty("seed", static_cast<int>(kSeed));
  }

  /// Near enough to overlap about every other time; in one place one time in sixteen.
  Pair next() {
    const Vector3 place = random_in_cube(random_, 2.0);
    const Vector3 apart = random_.below(16) == 0
                              ? Vector3(Vector3::Zero())
                              : Vector3(uniform_in(random_, 0.0, 1.6) * random_direction(random_));
    const auto [kind_a, kind_b] = GetParam();
    return {random_volume(random_, kind_a, place), random_volume(random_, kind_b, place + apart)};
  }

  RandomStream random_;
};

TEST_P(EveryPair, OverlapsWhenTheLeastDistanceSaysSoAndNeverOtherwise) {
  constexpr double kSearch_m = 1e-6;  // boxes that overlap are found to be almost no distance apart
  int apart = 0;
  int met = 0;
  for (int trial = 0; trial < kPairsOfVolumes; ++trial) {
    const auto [a, b] = next();
    const Corners of_a = corners_of(a);
    const Corners of_b = corners_of(b);
    const Bounds distance = searched_distance(of_a, of_b);
    const double reach_m = of_a.radius_m + of_b.radius_m;
    if (distance.least_m > reach_m + 1e-12) {
      ++apart;
      ASSERT_FALSE(overlap(a, b)) << "seed " << kSeed << ", trial " << trial;
      ASSERT_FALSE(overlap(b, a)) << "seed " << kSeed << ", trial " << trial;
    } else if (distance.most_m <= reach_m + (reach_m > 0.0 ? 0.0 : kSearch_m)) {
      ++met;
      ASSERT_TRUE(overlap(a, b)) << "seed " << kSeed << ", trial " << trial;
      ASSERT_TRUE(overlap(b, a)) << "seed " << kSeed << ", trial " << trial;
    }
  }
  EXPECT_GT(apart + met, kPairsOfVolumes * 97 / 100) << "the search decided too little";
  EXPECT_GT(met, kPairsOfVolumes / 10);
  EXPECT_GT(apart, kPairsOfVolumes / 10);
}

TEST_P(EveryPair, OverlapsWheneverASampledPointLiesInBoth) {
  int shared = 0;
  for (int trial = 0; trial < kPairsOfVolumes; ++trial) {
    const auto [a, b] = next();
    for (int sample = 0; sample < 40; ++sample) {
      const Vector3 of_a = point_within(random_, a);
      const Vector3 of_b = point_within(random_, b);
      if ((holds(a, of_a) && holds(b, of_a)) || (holds(b, of_b) && holds(a, of_b))) {
        ++shared;
        ASSERT_TRUE(overlap(a, b)) << "seed " << kSeed << ", trial " << trial;
        ASSERT_TRUE(overlap(b, a)) << "seed " << kSeed << ", trial " << trial;
      }
    }
  }
  EXPECT_GT(shared, kPairsOfVolumes);
}

TEST_P(EveryPair, TheContactIsTheSameBitsBothWaysRound) {
  for (int trial = 0; trial < kPairsOfVolumes; ++trial) {
    const auto [a, b] = next();
    const Vector3 fallback = random_direction(random_);
    TouchPoint turned = touch(b, a, -fallback);
    turned.normal = -turned.normal;
    ASSERT_TRUE(same_bits(touch(a, b, fallback), turned)) << "seed " << kSeed << ": " << trial;
    ASSERT_EQ(overlap(a, b), overlap(b, a));
  }
}

TEST_P(EveryPair, TheDepthAlongTheNormalIsTheWayThatPartsThem) {
  constexpr double kRounding_m = 1e-9;
  int deep = 0;
  for (int trial = 0; trial < kPairsOfVolumes; ++trial) {
    const auto [a, b] = next();
    const TouchPoint contact = touch(a, b, random_direction(random_));
    ASSERT_NEAR(contact.normal.norm(), 1.0, 1e-12);
    if (has_cube(a, b)) {  // theirs is the contact of a sphere: it parts them, and further
      ASSERT_FALSE(overlap(moved(a, (contact.depth_m + kRounding_m) * contact.normal), b));
      continue;
    }
    if (std::abs(contact.depth_m) > kRounding_m) {
      ASSERT_EQ(overlap(a, b), contact.depth_m > 0.0) << "seed " << kSeed << ", trial " << trial;
    }
    ASSERT_FALSE(overlap(moved(a, (contact.depth_m + kRounding_m) * contact.normal), b))
        << "seed " << kSeed << ", trial " << trial << ", depth " << contact.depth_m;
    if (content_m3(a) > 0.0 || content_m3(b) > 0.0) {  // what is flat passes through
      ASSERT_TRUE(overlap(moved(a, (contact.depth_m - kRounding_m) * contact.normal), b))
          << "seed " << kSeed << ", trial " << trial << ", depth " << contact.depth_m;
    }
    for (int other = 0; contact.depth_m > 0.01 && other < 8; ++other, ++deep) {
      const Vector3 way = 0.999 * contact.depth_m * random_direction(random_);
      ASSERT_TRUE(overlap(moved(a, way), b)) << "a shorter way parts them, trial " << trial;
    }
  }
  EXPECT_TRUE(deep > kPairsOfVolumes || GetParam().second == 4);
}

TEST_P(EveryPair, TheContactPointOfAnOverlapLiesInBoth) {
  for (int trial = 0; trial < kPairsOfVolumes; ++trial) {
    const auto [a, b] = next();
    if (overlap(a, b) && !has_cube(a, b)) {
      const TouchPoint contact = touch(a, b, Vector3::UnitY());
      ASSERT_TRUE(nearly_holds(a, contact.point)) << "seed " << kSeed << ", trial " << trial;
      ASSERT_TRUE(nearly_holds(b, contact.point)) << "seed " << kSeed << ", trial " << trial;
    }
  }
}

TEST_P(EveryPair, InterpenetrationGrowsFromTouchingToNested) {
  for (int trial = 0; trial < kPairsOfVolumes; ++trial) {
    const auto [a, b] = next();
    const TouchPoint contact = touch(a, b, Vector3::UnitX());
    const double degree = interpenetration(a, b, contact);
    ASSERT_GE(degree, 0.0);
    ASSERT_LE(degree, 1.0);
    if (contact.depth_m != 0.0) {  // at a touch, a volume without width is as deep as it can be
      ASSERT_EQ(degree > 0.0, contact.depth_m > 0.0) << "seed " << kSeed << ", trial " << trial;
    }
    TouchPoint shallower = contact;
    shallower.depth_m *= 0.5;
    ASSERT_LE(interpenetration(a, b, shallower), degree);
  }
}

TEST_P(EveryPair, MovesWithBothVolumes) {
  // A pose turns the answer with it; the rounding of coordinates within four metres.
  for (int trial = 0; trial < 300; ++trial) {
    const auto [a, b] = next();
    const Pose pose{random_in_cube(random_, 2.0), random_turn(random_)};
    const TouchPoint here = touch(a, b, Vector3::UnitX());
    const TouchPoint there =
        touch(placed(a, pose), placed(b, pose), pose.orientation * Vector3::UnitX());
    ASSERT_NEAR(here.depth_m, there.depth_m, 1e-9) << "seed " << kSeed << ": " << trial;
  }
}

std::vector<std::pair<int, int>> all_pairs() {
  std::vector<std::pair<int, int>> pairs;
  for (int a = 0; a < kKinds; ++a) {
    for (int b = a; b < kKinds; ++b) {
      pairs.emplace_back(a, b);
    }
  }
  return pairs;
}

INSTANTIATE_TEST_SUITE_P(OfKinds, EveryPair, ::testing::ValuesIn(all_pairs()),
                         [](const auto& each) {
                           return std::string(
                                      kKindNames[static_cast<std::size_t>(each.param.first)]) +
                                  "And" + kKindNames[static_cast<std::size_t>(each.param.second)];
                         });

}  // namespace impetus::volume_pairs_test
