// Which contacts are kept: the distance from a cone of pushes against every subset, and what the
// kept ones can still do.
// SPDX-License-Identifier: MIT
#include "engine/collision/torque_span.hpp"

#include <gtest/gtest.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "tests/engine/builders.hpp"
#include "tests/engine/once.hpp"

namespace impetus::torque_span_test {

constexpr std::uint64_t kSeed = 23;

Wrench random_wrench(RandomStream& random) {
  Wrench wrench;
  for (int i = 0; i < 6; ++i) {
    wrench[i] = uniform_in(random, -1.0, 1.0);
  }
  return wrench;
}

/// The oracle: the nearest point of the cone lies in the span of some subset, with positive parts.
double distance_by_subsets(const std::vector<Wrench>& generators, const Wrench& wrench) {
  double best = wrench.norm();
  for (unsigned subset = 1; subset < 1U << generators.size(); ++subset) {
    std::vector<std::size_t> members;
    for (std::size_t i = 0; i < generators.size(); ++i) {
      if ((subset >> i & 1U) != 0) {
        members.push_back(i);
      }
    }
    Eigen::MatrixXd columns(6, static_cast<Eigen::Index>(members.size()));
    for (std::size_t i = 0; i < members.size(); ++i) {
      columns.col(static_cast<Eigen::Index>(i)) = generators[members[i]];
    }
    const Eigen::VectorXd parts = columns.colPivHouseholderQr().solve(wrench);
    if (parts.minCoeff() >= 0.0) {
      best = std::min(best, (columns * parts - wrench).norm());
    }
  }
  return best;
}

TEST(DistanceFromCone, EqualsTheBestOverEverySubsetOfGenerators) {
  RandomStream random(kSeed, "cones");
  int inside = 0;
  for (int trial = 0; trial < 2'000; ++trial) {
    std::vector<Wrench> generators;
    const std::uint64_t count = 1 + random.below(8);
    for (std::uint64_t i = 0; i < count; ++i) {
      // Some repeat others or lie between them.
      const bool depends = i > 1 && random.below(4) == 0;
      generators.push_back(depends ? Wrench(generators[0] + random.uniform() * generators[1])
                                   : random_wrench(random));
    }
    Wrench wrench = random_wrench(random);
    if (random.below(3) == 0) {
      wrench = uniform_in(random, 0.0, 2.0) * generators[0] + random.uniform() * generators.back();
      ++inside;
      ASSERT_LT(distance_from_cone(generators, wrench), 1e-9)
          << "seed " << kSeed << ", trial " << trial;
    }
    ASSERT_NEAR(distance_from_cone(generators, wrench), distance_by_subsets(generators, wrench),
                1e-9)
        << "seed " << kSeed << ", trial " << trial;
  }
  EXPECT_GT(inside, 400);
}

TEST(DistanceFromCone, OfNothingIsAsFarAsTheWrenchIsLong) {
  RandomStream random(kSeed, "nothing");
  const Wrench wrench = random_wrench(random);
  EXPECT_EQ(distance_from_cone({}, wrench), wrench.norm());
}

bool is_kept(const std::vector<TouchPoint>& kept, const Vector3& point) {
  return std::any_of(kept.begin(), kept.end(),
                     [&](const TouchPoint& each) { return each.point == point; });
}

TEST(TorqueSpan, OfAFlatFaceItKeepsTheFourCorners) {
  std::vector<TouchPoint> face;
  for (int i = -3; i <= 3; ++i) {
    for (int j = -3; j <= 3; ++j) {
      face.push_back({{0.1 * i, 0.0, 0.05 * j}, Vector3::UnitY(), 0.01});
    }
  }
  const std::vector<TouchPoint> kept = spanning_most_torque(face, 4, 0.3);
  EXPECT_EQ(kept.size(), 4U);
  for (const double x : {-0.1 * 3, 0.1 * 3}) {
    for (const double z : {-0.05 * 3, 0.05 * 3}) {
      EXPECT_TRUE(is_kept(kept, {x, 0.0, z})) << x << ", " << z;
    }
  }
  EXPECT_TRUE(is_kept(spanning_most_torque(face, 1, 0.3), face[0].point)) << "the first of equals";
}

TEST(TorqueSpan, KeepsTheDeepestTheOrderAndAllThatAreNoMoreThanTheMost) {
  RandomStream random(kSeed, "kept");
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<TouchPoint> contacts;
    for (int i = 0; i < 12; ++i) {
      contacts.push_back({random_in_cube(random, 0.2), random_direction(random), random.uniform()});
    }
    EXPECT_EQ(spanning_most_torque(contacts, 12, 0.3).size(), 12U);
    const auto deepest = std::max_element(
        contacts.begin(), contacts.end(),
        [](const TouchPoint& x, const TouchPoint& y) { return x.depth_m < y.depth_m; });
    for (int most = 1; most < 12; ++most) {
      const std::vector<TouchPoint> kept = spanning_most_torque(contacts, most, 0.3);
      ASSERT_LE(kept.size(), static_cast<std::size_t>(most));
      ASSERT_TRUE(is_kept(kept, deepest->point)) << "seed " << kSeed << ", trial " << trial;
      std::size_t from = 0;
      for (const TouchPoint& each : kept) {
        while (from < contacts.size() && contacts[from].point != each.point) {
          ++from;
        }
        ASSERT_LT(from, contacts.size()) << "out of order, or not one of them";
      }
    }
  }
}

TEST(TorqueSpan, WhereTheKeptDoNotApproachNoneOfThoseLeftOutDoes) {
  // Few enough corners that all of the cone fits: a convex face with points within it.
  RandomStream random(kSeed, "farkas");
  int left_out = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const Pose pose{random_in_cube(random, 1.0), random_turn(random)};
    const Vector3 normal = pose.orientation * Vector3::UnitY();
    std::vector<TouchPoint> contacts;
    for (int i = 0; i < 20; ++i) {
      const bool corner = i < 5;
      const double angle = 2.0 * 3.14159265 * (corner ? i : 5.0 * random.uniform()) / 5.0;
      const double radius_m = corner ? 0.2 : 0.15 * random.uniform();
      contacts.push_back(
          {pose.transform({radius_m * std::cos(angle), 0.0, radius_m * std::sin(angle)}), normal,
           random.uniform()});
    }
    const std::vector<TouchPoint> kept = spanning_most_torque(contacts, 6, 0.2);
    left_out += static_cast<int>(contacts.size() - kept.size());
    for (int motion = 0; motion < 20; ++motion) {
      const Vector3 velocity = random_in_cube(random, 1.0);
      const Vector3 spin = random_in_cube(random, 3.0);
      const auto slowest = [&](const std::vector<TouchPoint>& of) {
        double least = 1e9;
        for (const TouchPoint& each : of) {
          least = std::min(least, normal.dot(velocity + spin.cross(each.point - pose.position)));
        }
        return least;
      };
      ASSERT_NEAR(slowest(kept), slowest(contacts), 1e-5)
          << "seed " << kSeed << ", trial " << trial;
    }
  }
  EXPECT_GE(left_out, 300 * 14);
}

TEST(TorqueSpan, TurningTheNormalsKeepsTheSameContacts) {
  RandomStream random(kSeed, "turned");
  for (int trial = 0; trial < 100; ++trial) {
    std::vector<TouchPoint> contacts;
    std::vector<TouchPoint> turned;
    for (int i = 0; i < 15; ++i) {
      contacts.push_back({random_in_cube(random, 0.2), random_direction(random), random.uniform()});
      turned.push_back({contacts.back().point, -contacts.back().normal, contacts.back().depth_m});
    }
    const std::vector<TouchPoint> kept = spanning_most_torque(contacts, 4, 0.3);
    const std::vector<TouchPoint> kept_of_turned = spanning_most_torque(turned, 4, 0.3);
    ASSERT_EQ(kept.size(), kept_of_turned.size());
    for (std::size_t i = 0; i < kept.size(); ++i) {
      ASSERT_EQ(kept[i].point, kept_of_turned[i].point);
    }
  }
}

}  // namespace impetus::torque_span_test
