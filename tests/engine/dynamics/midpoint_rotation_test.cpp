// Rotations of many bodies at a time against Eigen's arithmetic, one by one: the same bits,
// whatever the width of the vectors.
// SPDX-License-Identifier: MIT
#include "engine/dynamics/midpoint_rotation.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "engine/dynamics/motion.hpp"
#include "tests/engine/builders.hpp"

namespace impetus::midpoint_rotation_test {

constexpr std::uint64_t kSeed = 82;

Quaternion by_eigen(const BodyModel& model, const BodyState& state, double dt_s) {
  const Quaternion start = state.pose.orientation;
  Quaternion middle = start;
  Quaternion end = start;
  for (int iteration = 0; iteration <= 4; ++iteration) {
    const Matrix3 rotation = middle.toRotationMatrix();
    const Vector3 spin =
        rotation * (model.inverse_inertia * Vector3(rotation.transpose() * state.angular_momentum));
    const Vector3 turn = spin * dt_s;
    const Quaternion cayley =
        Quaternion(1.0, 0.5 * turn.x(), 0.5 * turn.y(), 0.5 * turn.z()).normalized();
    end = (cayley * start).normalized();
    middle = Quaternion(Eigen::Vector4d(start.coeffs() + end.coeffs())).normalized();
  }
  return end;
}

/// A body of any inertia, some of them principal ones alone, and how it turns.
struct Turning {
  BodyModel model;
  BodyState state;
};

Turning random_turning(RandomStream& random) {
  Turning one;
  one.model.inverse_mass = 1.0;
  const Vector3 inverse = Vector3(1.1, 1.1, 1.1) + random_in_cube(random, 1.0);
  const Matrix3 axes =
      random.below(2) == 0 ? Matrix3(Matrix3::Identity()) : random_turn(random).toRotationMatrix();
  one.model.inverse_inertia = axes * inverse.asDiagonal() * axes.transpose();
  one.state.pose.orientation = random_turn(random);
  one.state.angular_momentum = random_in_cube(random, 4.0);
  return one;
}

/// As it turns alone.
Quaternion alone(Turning one, double dt_s) {
  TurningBodies turning;
  turning.put(one.model, one.state, dt_s);
  turning.turn();
  return one.state.pose.orientation;
}

void expect_same(const Quaternion& found, const Quaternion& expected) {
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(found.coeffs()[i], expected.coeffs()[i]) << i;
  }
}

TEST(MidpointRotation, OfOneHasTheBitsOfEigen) {
  RandomStream random(kSeed, "one");
  for (int trial = 0; trial < 2'000; ++trial) {
    const Turning one = random_turning(random);
    const double dt_s = uniform_in(random, 0.001, 0.1);
    expect_same(alone(one, dt_s), by_eigen(one.model, one.state, dt_s));
  }
}

TEST(MidpointRotation, OfManyHasTheBitsOfEachAlone) {
  for (const LaneWidth width : {LaneWidth::kTwo, LaneWidth::kFour, LaneWidth::kEight}) {
    if (width > widest_lanes()) {
      continue;
    }
    RandomStream random(kSeed, "many");
    TurningBodies turning;
    for (int count = 1; count <= kLanes; ++count) {
      std::vector<Turning> all;
      std::vector<Quaternion> expected;
      for (int i = 0; i < count; ++i) {
        all.push_back(random_turning(random));
      }
      for (Turning& one : all) {
        const double dt_s = uniform_in(random, 0.001, 0.1);
        expected.push_back(alone(one, dt_s));
        turning.put(one.model, one.state, dt_s);
      }
      EXPECT_EQ(turning.is_full(), count == kLanes);
      turning.turn(width);
      for (std::size_t i = 0; i < all.size(); ++i) {
        expect_same(all[i].state.pose.orientation, expected[i]);
      }
    }
  }
}

// What one lane holds is nothing to the others, even if it is no number.
TEST(MidpointRotation, OneThatIsNotFiniteLeavesTheOthersAsTheyWere) {
  RandomStream random(kSeed, "not finite");
  std::vector<Turning> all;
  for (int i = 0; i < kLanes; ++i) {
    all.push_back(random_turning(random));
  }
  all[3].state.angular_momentum.x() = std::numeric_limits<double>::infinity();
  std::vector<Quaternion> expected;
  TurningBodies turning;
  for (Turning& one : all) {
    expected.push_back(alone(one, 0.1));
    turning.put(one.model, one.state, 0.1);
  }
  turning.turn();
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (i == 3) {
      EXPECT_FALSE(all[i].state.pose.orientation.coeffs().allFinite());
    } else {
      expect_same(all[i].state.pose.orientation, expected[i]);
    }
  }
}

// Held, without spin, spinning far, falling: each moves as it does alone.
TEST(AdvancingBodies, MoveAsEachDoesAlone) {
  RandomStream random(kSeed, "advance");
  for (const Rotation rotation : {Rotation::kMidpoint, Rotation::kEnergyKept}) {
    std::vector<Turning> all;
    for (int i = 0; i < 100; ++i) {
      Turning& one = all.emplace_back(random_turning(random));
      one.state.linear_momentum = random_in_cube(random, 1.0);
      one.state.held_s = i % 5 == 0 ? 0.01 * i / 10.0 : 0.0;
      if (i % 7 == 0) {
        one.state.angular_momentum *= i % 2 == 0 ? 0.0 : 100.0;
      }
      if (i % 11 == 0) {
        one.model.inverse_inertia.setZero();
      }
    }
    std::vector<Turning> apart = all;
    AdvancingBodies advancing;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const Fall fall{i % 3 == 0 ? Vector3(0.0, -9.81, 0.0) : Vector3(0.0, 0.0, 0.0)};
      const double way_m = advance(apart[i].model, apart[i].state, 0.05, rotation, fall);
      EXPECT_EQ(advancing.take(all[i].model, all[i].state, 0.05, rotation, fall), way_m);
    }
    advancing.finish();
    for (std::size_t i = 0; i < all.size(); ++i) {
      EXPECT_EQ(all[i].state.pose.position, apart[i].state.pose.position);
      EXPECT_EQ(all[i].state.linear_momentum, apart[i].state.linear_momentum);
      EXPECT_EQ(all[i].state.held_s, apart[i].state.held_s);
      expect_same(all[i].state.pose.orientation, apart[i].state.pose.orientation);
    }
  }
}

}  // namespace impetus::midpoint_rotation_test
