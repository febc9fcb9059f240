// Free and driven motion of figures.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "engine/figures/hinge_solver.hpp"
#include "tests/engine/figure_flight.hpp"

namespace impetus::figure_motion_test {

TEST(FigureMotion, AFreeFigureTumblesWithItsMomentumItsEnergyAndItsHinges) {
  for (const Rotation rotation : {Rotation::kMidpoint, Rotation::kEnergyKept}) {
    const Flight flight = fly(2000, 0.02, rotation);
    EXPECT_LT(flight.momentum_drift, 1e-13);
    EXPECT_LT(flight.angular_drift, 1e-12);
    EXPECT_LT(flight.energy_drift, 1e-9);
    EXPECT_LT(flight.widest_gap_m, 1e-10);
  }
}

TEST(FigureMotion, AWildOneStillKeepsMomentumAndGainsNoEnergy) {
  const Flight flight = fly(300, 2.0, Rotation::kMidpoint);
  EXPECT_LT(flight.momentum_drift, 1e-12);
  EXPECT_LT(flight.angular_drift, 1e-11);
  EXPECT_LT(flight.widest_gap_m, 1e-8);
}

/// The whole system by a dense matrix: M u = f + Jᵀλ, J u = 0.
TEST(FigureMotion, TheTreeSolverAgreesWithADenseOne) {
  const FigureScene scene = limbs_of_16();
  RandomStream random(4, "dense");
  const Pose root{random_in_cube(random, 1.0), random_turn(random)};
  const std::vector<BodyState> states = states_of(
      scene.figure, scene.models, poses_of(scene.figure, root, random_angles(scene.figure, random)),
      Vector3::Zero(), Vector3::Zero());
  const std::size_t parts = states.size();
  const std::size_t hinges = scene.figure.hinges.size();
  Eigen::MatrixXd inverse_mass = Eigen::MatrixXd::Zero(6 * parts, 6 * parts);
  for (std::size_t i = 0; i < parts; ++i) {
    inverse_mass.block<3, 3>(6 * i, 6 * i) = scene.models[i].inverse_mass * Matrix3::Identity();
    inverse_mass.block<3, 3>(6 * i + 3, 6 * i + 3) =
        world_inverse_inertia(scene.models[i], states[i]);
  }
  HingeSolver solver(scene.figure, scene.models);
  solver.look_at(states);
  Eigen::MatrixXd jacobian(5 * hinges, 6 * parts);
  for (std::size_t column = 0; column < 6 * parts; ++column) {
    std::vector<BodyState> moving = states;  // at a unit velocity of one coordinate
    for (BodyState& state : moving) {
      state.linear_momentum.setZero();
      state.angular_momentum.setZero();
    }
    const std::size_t part = column / 6;
    const auto axis = static_cast<Eigen::Index>(column % 3);
    if (column % 6 < 3) {
      moving[part].linear_momentum(axis) = 1.0 / scene.models[part].inverse_mass;
    } else {
      moving[part].angular_momentum = angular_momentum_at(
          scene.models[part], states[part].pose.orientation, Vector3::Unit(axis));
    }
    for (std::size_t hinge = 0; hinge < hinges; ++hinge) {
      jacobian.block<5, 1>(5 * hinge, column) = solver.speed_across(hinge, moving);
    }
  }
  Eigen::VectorXd applied(6 * parts);
  std::vector<PartImpulse> impulses(parts);
  for (std::size_t i = 0; i < parts; ++i) {
    impulses[i] = {random_direction(random), random_direction(random)};
    applied.segment<3>(6 * i) = impulses[i].linear;
    applied.segment<3>(6 * i + 3) = impulses[i].angular;
  }
  const Eigen::VectorXd of_hinges =
      -jacobian.transpose() * (jacobian * inverse_mass * jacobian.transpose())
                                  .ldlt()
                                  .solve(jacobian * inverse_mass * applied);
  solver.add_hinge_impulses(impulses);
  Vector3 sum = Vector3::Zero();
  for (std::size_t i = 0; i < parts; ++i) {
    const Eigen::VectorXd expected = applied.segment(6 * i, 6) + of_hinges.segment(6 * i, 6);
    EXPECT_LT((impulses[i].linear - expected.head(3)).norm(), 1e-9);
    EXPECT_LT((impulses[i].angular - expected.tail(3)).norm(), 1e-9);
    sum += impulses[i].linear - Vector3(applied.segment<3>(6 * i));
  }
  EXPECT_LT(sum.norm(), 1e-14);
}

TEST(FigureMotion, APendulumSwingsAtItsPeriod) {
  FigureScene scene = chain_of(2, /*about_z_alone=*/true);
  scene.models[0].inverse_mass = 0.0;  // hangs from a fixed root
  scene.models[0].inverse_inertia.setZero();
  scene.figure.self_collision = {false, false};
  const double start = -0.5 * kPi + 0.05;  // hanging down from a root along x, .05 rad aside
  const std::vector<BodyState> states =
      states_of(scene.figure, scene.models, poses_of(scene.figure, {}, {start}), Vector3::Zero(),
                Vector3::Zero());
  WorldSettings settings;
  settings.figures = {scene.figure};
  settings.gravity_m_s2 = Vector3(0.0, -9.81, 0.0);
  World world(scene.models, states, settings);
  const double arm_m = 0.5 * kPartLength_m;
  const double mass_kg = 1.0 / scene.models[1].inverse_mass;
  const double inertia = 1.0 / scene.models[1].inverse_inertia(2, 2) + mass_kg * arm_m * arm_m;
  const double period_s = 2.0 * kPi * std::sqrt(inertia / (mass_kg * 9.81 * arm_m));
  const Hinge& hinge = scene.figure.hinges[0];
  int crossings = 0;
  double last_s = 0.0;
  double before = 1.0;
  FixedWork work(0);
  const int steps = static_cast<int>(20.0 * period_s / kStep_s);
  for (int step = 1; step <= steps; ++step) {
    world.step({kStep_s, {}}, work);
    const double angle =
        angle_of(hinge, world.states()[1].pose, world.states()[0].pose) + 0.5 * kPi;
    if (before < 0.0 && angle >= 0.0) {
      ++crossings;
      last_s = step * kStep_s - kStep_s * angle / (angle - before);
    }
    before = angle;
  }
  // The first crossing upwards comes after three quarters of a period.
  EXPECT_NEAR(last_s / (crossings - 0.25), period_s, 2e-3 * period_s);
  EXPECT_EQ(world.states()[0].pose.position, Vector3::Zero());
}

TEST(FigureMotion, ADrivenFigureGoesAsItsMotionSaysWhateverItMeets) {
  FigureScene scene = limbs_of_16();
  JointMotion motion;
  motion.period_s = 0.8;
  motion.root.velocity_m_s = Vector3(0.5, 0.0, 0.0);
  motion.root.spin_rad_s = Vector3(0.0, 1.0, 0.0);
  for (const Hinge& hinge : scene.figure.hinges) {
    motion.waves.push_back({hinge.rest_rad, 0.4, 0.1 * hinge.child, 1 + hinge.child % 2});
  }
  scene.figure.driven = motion;
  scene.figure.self_collision = {false, false};
  std::vector<BodyState> states = driven_states(scene.figure, scene.models, 0.0, kStep_s);
  scene.models.push_back(ball(0.2, 1.0));
  states.push_back(resting_at(Vector3(0.6, 0.0, 0.0)));
  WorldSettings settings;
  settings.figures = {scene.figure};
  World world(scene.models, states, settings);
  FixedWork work(1'000'000);
  bool met = false;
  double time_s = 0.0;
  for (int step = 1; step <= 240; ++step) {
    met = !world.step({kStep_s, {}}, work).collisions.empty() || met;
    time_s += kStep_s;
    std::vector<double> angles;
    for (std::size_t joint = 0; joint < scene.figure.hinges.size(); ++joint) {
      angles.push_back(joint_angle(motion, joint, time_s));
    }
    const std::vector<Pose> expected = poses_of(scene.figure, root_pose(motion, time_s), angles);
    for (std::size_t part = 0; part < expected.size(); ++part) {
      ASSERT_EQ(world.states()[part].pose.position, expected[part].position);
    }
  }
  EXPECT_TRUE(met);
  EXPECT_GT(world.states().back().linear_momentum.norm(), 0.1);
}

TEST(FigureMotion, RecordedKeysAreMetAndJoinedSmoothly) {
  JointMotion motion;
  motion.repeats = true;
  motion.keys = {{0.0, {0.0}}, {0.5, {1.0}}, {1.0, {-0.5}}, {1.5, {0.0}}};
  for (const JointKey& key : motion.keys) {
    EXPECT_NEAR(joint_angle(motion, 0, key.time_s + 3.0), key.angles_rad[0], 1e-12);
  }
  for (const double time_s : {0.5, 1.0, 1.5, 3.0}) {
    constexpr double kAside_s = 1e-6;
    const double before =
        joint_angle(motion, 0, time_s) - joint_angle(motion, 0, time_s - kAside_s);
    const double after = joint_angle(motion, 0, time_s + kAside_s) - joint_angle(motion, 0, time_s);
    EXPECT_NEAR(before / kAside_s, after / kAside_s, 1e-3);
  }
  motion.repeats = false;
  EXPECT_EQ(joint_angle(motion, 0, 9.0), 0.0);
  motion.keys[1].angles_rad = {1.0, 2.0};
  EXPECT_EQ(problem_of(motion, 1), "expected 1 angles in each key, got 2 in key 1");
}

TEST(FigureMotion, WhatDrivesAFigureIsOfFiniteNumbers) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  JointMotion keys;
  keys.keys = {{0.0, {0.0}}, {1.0, {1.0}}};
  ASSERT_EQ(problem_of(keys, 1), "");
  keys.keys[1].angles_rad[0] = kNan;
  EXPECT_EQ(problem_of(keys, 1), "expected keys of finite numbers, got another in key 1");
  keys.keys[1] = {std::numeric_limits<double>::infinity(), {1.0}};
  EXPECT_EQ(problem_of(keys, 1), "expected keys of finite numbers, got another in key 1");
  JointMotion waves;
  waves.waves.resize(1);
  ASSERT_EQ(problem_of(waves, 1), "");
  waves.waves[0].amplitude_rad = kNan;
  EXPECT_EQ(problem_of(waves, 1), "expected waves of finite numbers, got another");
  waves.waves[0] = {};
  waves.root.start.orientation.coeffs() *= 1.5;
  EXPECT_EQ(problem_of(waves, 1),
            "expected a root's orientation of unit length, got one of 1.500000");
}

TEST(FigureMotion, StepsAreTheSameToTheBitWhoeverMakesThem) {
  FigureScene scene = limbs_of_16();
  RandomStream random(7, "bits");
  std::vector<BodyState> states = scene.at_rest();
  stir(scene, 0.05, random, states);
  WorldSettings settings;
  settings.figures = {scene.figure};
  settings.enclosure = Enclosure{ClosedCube{1.2}};
  World one(scene.models, states, settings);
  FixedWork work(100'000);
  for (int step = 0; step < 200; ++step) {
    one.step({kStep_s, {}}, work);
  }
  World other = one;  // in the middle, with all that it remembers
  for (int step = 0; step < 200; ++step) {
    FixedWork same(100'000);
    const StateHash first = one.step({kStep_s, {}}, work).state;
    ASSERT_EQ(first.hash, other.step({kStep_s, {}}, same).state.hash);
  }
}

TEST(FigureMotion, AFigureOfWhichAPartIsNoNumberIsOutAsAWhole) {
  const FigureScene scene = chain_of(4);
  WorldSettings settings;
  settings.figures = {scene.figure};
  World world(scene.models, scene.at_rest(), settings);
  world.mutable_states()[2].linear_momentum.x() = std::numeric_limits<double>::infinity();
  FixedWork work(1000);
  const StepReport& report = world.step({kStep_s, {}}, work);
  ASSERT_EQ(report.not_finite.size(), 1U);
  EXPECT_EQ(report.not_finite[0].body, 2);
  const std::vector<BodyState> after = world.states();
  world.step({kStep_s, {}}, work);
  for (std::size_t part = 0; part < 4; ++part) {
    EXPECT_EQ(world.states()[part].pose.position, after[part].pose.position);
    EXPECT_TRUE(world.states()[part].linear_momentum.isZero(0.0));
  }
}

}  // namespace impetus::figure_motion_test
