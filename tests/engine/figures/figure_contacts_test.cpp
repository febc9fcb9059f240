// Figures that meet something: impulses on parts, limits, self-collisions.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>

#include "engine/figures/figure_motion.hpp"
#include "engine/figures/hinged_responder.hpp"
#include "engine/volumes/volume.hpp"
#include "tests/engine/figure_scenes.hpp"

namespace impetus::figure_contacts_test {

constexpr std::int64_t kPlenty = 10'000'000;

double speed_across_hinges(const FigureScene& scene, const std::vector<BodyState>& states) {
  HingeSolver solver(scene.figure, scene.models);
  solver.look_at(states);
  double fastest = 0.0;
  for (std::size_t hinge = 0; hinge < scene.figure.hinges.size(); ++hinge) {
    fastest = std::max(fastest, solver.speed_across(hinge, states).norm());
  }
  return fastest;
}

TEST(FigureContacts, AnImpulseOnAnyPartMovesTheWholeAndKeepsMomentumAndEnergy) {
  FigureScene scene = limbs_of_16();
  scene.figure.self_collision = {false, false};
  const std::vector<BodyState> at_rest = scene.at_rest();
  for (std::size_t part = 0; part < at_rest.size(); ++part) {
    FigureScene with_ball = scene;
    with_ball.models.push_back(ball(0.05, 0.5));
    std::vector<BodyState> states = at_rest;
    BodyState shot;  // at the part's middle, across its axis
    const Vector3 away = at_rest[part].pose.orientation * Vector3::UnitZ();
    shot.pose.position = at_rest[part].pose.position + (0.05 + kPartRadius_m + 0.01) * away;
    shot.linear_momentum = -2.0 * away;
    states.push_back(shot);
    WorldSettings settings;
    settings.figures = {scene.figure};
    World world(with_ball.models, states, settings);
    const double energy_J = energy_of(with_ball.models, states);
    const WholeMomentum before = momentum_of(states);
    FixedWork work(kPlenty);
    bool hit = false;
    for (int step = 0; step < 5 && !hit; ++step) {
      const StepReport& report = world.step({kStep_s, {}}, work);
      hit = !report.collisions.empty();
    }
    ASSERT_TRUE(hit) << part;
    const std::vector<BodyState>& after = world.states();
    for (std::size_t other = 0; other < at_rest.size(); ++other) {
      const double speed = velocity(scene.models[other], after[other]).norm() +
                           angular_velocity(scene.models[other], after[other]).norm();
      EXPECT_GT(speed, 1e-6) << "part " << other << " after a hit on " << part;
    }
    EXPECT_LT(speed_across_hinges(scene, after), 1e-11);
    EXPECT_NEAR(energy_of(with_ball.models, after), energy_J, 1e-11 * energy_J);
    EXPECT_LT((momentum_of(after).linear - before.linear).norm(), 1e-13);
    EXPECT_LT((momentum_of(after).angular - before.angular).norm(), 1e-13);
  }
}

TEST(FigureContacts, WhatHingesHoldIsNotPushedByWhatRoundingLeaves) {
  // Hinges that turn about z alone: across their plane no part moves against another.
  FigureScene scene = chain_of(3, /*about_z_alone=*/true);
  const std::vector<std::int32_t> figure_of(at(scene.figure.part_count), 0);
  RandomStream random(4, "held");
  int given_by_rounding = 0;
  for (int trial = 0; trial < 20; ++trial) {
    const Quaternion turn = random_turn(random);
    std::vector<BodyState> states = scene.at_rest();
    for (BodyState& state : states) {
      state.pose = {turn * state.pose.position, turn * state.pose.orientation};
    }
    std::vector<FigureMotion> motions{FigureMotion(scene.figure, scene.models)};
    const auto give = [&](double least_share, const Vector3& along) {
      Contact contact;
      contact.bodies = {0, 2};
      contact.touch.point = states[1].pose.position + 0.1 * (turn * Vector3::UnitY());
      contact.touch.normal = turn * along;
      HingedBodies bodies;
      bodies.gather({contact}, {}, least_share, scene.models, states,
                    {std::span(&scene.figure, 1), motions, figure_of});
      return bodies.give(0);
    };
    const double least_share = ResponseRules().least_share_of_give;
    EXPECT_EQ(give(least_share, Vector3::UnitZ()), 0.0) << trial;
    const double free = give(least_share, Vector3::UnitX());
    EXPECT_GT(free, 0.1) << "parts of 1 kg";
    EXPECT_EQ(give(0.0, Vector3::UnitX()), free);
    const double left = give(0.0, Vector3::UnitZ());
    EXPECT_LT(left, 1e-12 * free);
    given_by_rounding += left > 0.0 ? 1 : 0;
  }
  EXPECT_GT(given_by_rounding, 0);
}

TEST(FigureContacts, HingesStopAtTheirLimits) {
  FigureScene scene = limbs_of_16();
  scene.figure.self_collision = {false, false};
  RandomStream random(3, "limits");
  std::vector<BodyState> states = scene.at_rest();
  stir(scene, 0.05, random, states);
  WorldSettings settings;
  settings.figures = {scene.figure};
  World world(scene.models, states, settings);
  const WholeMomentum before = momentum_of(world.states());
  double energy_J = energy_of(scene.models, world.states());
  const double first_J = energy_J;
  double farthest_beyond = 0.0;
  std::set<std::int32_t> reached;
  FixedWork work(kPlenty);
  for (int step = 0; step < 1000; ++step) {
    world.step({kStep_s, {}}, work);
    for (const Hinge& hinge : scene.figure.hinges) {
      const double angle =
          angle_of(hinge, world.states()[hinge.child].pose, world.states()[hinge.parent].pose);
      const double beyond = std::max(hinge.least_rad - angle, angle - hinge.most_rad);
      farthest_beyond = std::max(farthest_beyond, beyond);
      if (beyond > -1e-3) {
        reached.insert(hinge.child);
      }
    }
    const double now_J = energy_of(scene.models, world.states());
    EXPECT_LE(now_J, energy_J * (1.0 + 1e-9));
    energy_J = now_J;
  }
  EXPECT_LT(farthest_beyond, 2.0 / 180.0 * kPi);
  EXPECT_GT(reached.size(), 5U);
  EXPECT_LT(energy_J, 0.9 * first_J);  // limits give nothing back
  EXPECT_LT((momentum_of(world.states()).angular - before.angular).norm(),
            1e-12 * before.angular.norm());
}

/// What brute force finds: parts that no hinge joins whose volumes overlap.
std::set<std::pair<std::int32_t, std::int32_t>> overlapping_parts(const FigureScene& scene,
                                                                  const std::vector<Pose>& poses) {
  std::set<std::pair<std::int32_t, std::int32_t>> found;
  for (std::int32_t a = 0; a < scene.figure.part_count; ++a) {
    for (std::int32_t b = a + 1; b < scene.figure.part_count; ++b) {
      const auto volume = [&](std::int32_t part) {
        return placed(scene.models[part].tree->volume(0), poses[part]);
      };
      if (hinge_between(scene.figure, {a, b}) == nullptr && overlap(volume(a), volume(b))) {
        found.emplace(a, b);
      }
    }
  }
  return found;
}

TEST(SelfCollision, NoIntersectingPairOfPartsIsMissed) {
  const FigureScene scene = limbs_of_16();
  RandomStream random(5, "tangles");
  std::size_t pairs = 0;
  std::size_t folds = 0;
  for (int i = 0; i < 2000; ++i) {
    const Pose root{random_in_cube(random, 1.0), random_turn(random)};
    const std::vector<Pose> poses =
        poses_of(scene.figure, root, random_angles(scene.figure, random));
    WorldSettings settings;
    settings.figures = {scene.figure};
    World world(scene.models,
                states_of(scene.figure, scene.models, poses, Vector3::Zero(), Vector3::Zero()),
                settings);
    FixedWork work(kPlenty);
    std::set<std::pair<std::int32_t, std::int32_t>> others;
    std::set<std::pair<std::int32_t, std::int32_t>> neighbours;
    for (const CollisionReport& each : world.step({0.0, {}}, work).collisions) {
      const bool joined = hinge_between(scene.figure, each.bodies) != nullptr;
      (joined ? neighbours : others).emplace(each.bodies.a, each.bodies.b);
    }
    EXPECT_EQ(others, overlapping_parts(scene, poses));
    std::set<std::pair<std::int32_t, std::int32_t>> folded;
    for (const Hinge& hinge : scene.figure.hinges) {
      if (is_folded(hinge, poses[hinge.child], poses[hinge.parent])) {
        folded.emplace(hinge.parent, hinge.child);
      }
    }
    EXPECT_EQ(neighbours, folded);
    pairs += others.size();
    folds += folded.size();
  }
  EXPECT_GT(pairs, 500U);
  EXPECT_GT(folds, 500U);
}

TEST(SelfCollision, EachKindCanBeSwitchedOff) {
  FigureScene scene = limbs_of_16();
  RandomStream random(6, "switches");
  std::vector<Pose> poses;
  std::size_t expected = 0;
  std::size_t folded = 0;
  while (expected == 0 || folded == 0) {
    poses = poses_of(scene.figure, {}, random_angles(scene.figure, random));
    expected = overlapping_parts(scene, poses).size();
    folded = 0;
    for (const Hinge& hinge : scene.figure.hinges) {
      folded += is_folded(hinge, poses[hinge.child], poses[hinge.parent]) ? 1 : 0;
    }
  }
  const auto collisions = [&](SelfCollision self) {
    scene.figure.self_collision = self;
    WorldSettings settings;
    settings.figures = {scene.figure};
    World world(scene.models,
                states_of(scene.figure, scene.models, poses, Vector3::Zero(), Vector3::Zero()),
                settings);
    FixedWork work(kPlenty);
    return world.step({0.0, {}}, work).collisions.size();
  };
  EXPECT_EQ(collisions({true, true}), expected + folded);
  EXPECT_EQ(collisions({true, false}), expected);
  EXPECT_EQ(collisions({false, true}), folded);
  EXPECT_EQ(collisions({false, false}), 0U);
}

TEST(SelfCollision, NeighboursAtRestNeverCollide) {
  const FigureScene scene = limbs_of_16();
  RandomStream random(8, "rests");
  for (int i = 0; i < 100; ++i) {
    WorldSettings settings;
    settings.figures = {scene.figure};
    World world(scene.models, scene.at_rest({random_in_cube(random, 1.0), random_turn(random)}),
                settings);
    FixedWork work(kPlenty);
    for (const CollisionReport& each : world.step({kStep_s, {}}, work).collisions) {
      EXPECT_EQ(hinge_between(scene.figure, each.bodies), nullptr);
    }
  }
}

TEST(SelfCollision, AFoldIsPushedOpenByAnImpulseThatGainsNoEnergy) {
  FigureScene scene = chain_of(2, /*about_z_alone=*/true);
  scene.figure.hinges[0].fold_rad = 1.0;
  std::vector<BodyState> states =
      states_of(scene.figure, scene.models, poses_of(scene.figure, {}, {0.9}), Vector3::Zero(),
                Vector3::Zero());
  states[1].angular_momentum = Vector3(0.0, 0.0, 0.05);
  Figures({scene.figure}, scene.models).begin({scene.figure}, states);
  WorldSettings settings;
  settings.figures = {scene.figure};
  World world(scene.models, states, settings);
  const double energy_J = energy_of(scene.models, world.states());
  FixedWork work(kPlenty);
  const Hinge& hinge = scene.figure.hinges[0];
  bool folded = false;
  double impulse = 0.0;
  for (int step = 0; step < 240; ++step) {
    const StepReport& report = world.step({kStep_s, {}}, work);
    folded = folded || !report.collisions.empty();
    impulse += report.collisions.empty() ? 0.0 : report.collisions[0].impulse_Ns;
  }
  EXPECT_TRUE(folded);
  EXPECT_GT(impulse, 0.0);
  EXPECT_LT(angle_of(hinge, world.states()[1].pose, world.states()[0].pose), 0.9);
  EXPECT_NEAR(energy_of(scene.models, world.states()), energy_J, 1e-9 * energy_J);  // elastic
}

TEST(FigureContacts, AFigureThatLiesDoesNotSinkThroughTheFloor) {
  const FigureScene scene = limbs_of_16();
  const auto lowest_m = [&](int recording_format, std::int64_t units_of_motion) {
    WorldSettings settings;
    settings.figures = {scene.figure};
    settings.restitution = 0.0;
    settings.gravity_m_s2 = Vector3(0.0, -9.81, 0.0);
    settings.enclosure = Enclosure{ClosedCube{1.0}};
    settings.recording_format = recording_format;
    std::vector<BodyState> states = scene.at_rest({{0.0, -0.5, 0.0}, Quaternion::Identity()});
    RandomStream random(1, "lies");
    stir(scene, 1e-2, random, states);
    World world(scene.models, states, settings);
    WorkGrants grants;
    grants.of(WorkPhase::kMotion) = units_of_motion;
    FixedWork work(grants);
    for (int step = 0; step < 30 * 4; ++step) {
      world.step({1.0 / 30.0, {}}, work);
    }
    double lowest = 1.0;
    for (const BodyState& state : world.states()) {
      lowest = std::min(lowest, state.pose.position.y());
    }
    return lowest;
  };
  // The lowest centre ends 4 mm below the floor, of parts that are 6 cm thick.
  EXPECT_GT(lowest_m(kRecordingFormat, kUnlimitedTests), -1.0 - 0.5 * kPartRadius_m);
  EXPECT_GT(lowest_m(kRecordingFormat, 0), -1.0 - 0.5 * kPartRadius_m) << "as one body";
  EXPECT_GT(lowest_m(kRecordingFormat, 300), -1.0 - 0.5 * kPartRadius_m) << "now and then";
  EXPECT_LT(lowest_m(3, kUnlimitedTests), -1.2) << "what recordings of format 3 were made by";
}

TEST(FigureContacts, AChainOfTwentyHingesDroppedOnATableSettlesAndGainsNoEnergy) {
  FigureScene scene = chain_of(21);
  scene.figure.self_collision = {true, false};
  RandomStream random(9, "chain");
  std::vector<double> angles;
  for (std::size_t i = 0; i < scene.figure.hinges.size(); ++i) {
    angles.push_back(uniform_in(random, -0.3, 0.3));
  }
  const Pose root{Vector3(-2.8, -3.0, 0.0), Quaternion::Identity()};
  const std::vector<BodyState> states =
      states_of(scene.figure, scene.models, poses_of(scene.figure, root, angles), Vector3::Zero(),
                Vector3::Zero());
  WorldSettings settings;
  settings.figures = {scene.figure};
  settings.restitution = 0.3;
  settings.gravity_m_s2 = Vector3(0.0, -9.81, 0.0);
  settings.enclosure = Enclosure{ClosedCube{4.0}};
  World world(scene.models, states, settings);
  const double first_J = energy_of(scene.models, states, settings.gravity_m_s2);
  double lowest_J = first_J;
  double regained_J = 0.0;  ///< since the lowest
  double gap_m = 0.0;
  double gain_J = 0.0;
  FixedWork work(kPlenty);
  double speed = 0.0;
  for (int step = 0; step < 5000; ++step) {
    world.step({kStep_s, {}}, work);
    const double now_J = energy_of(scene.models, world.states(), settings.gravity_m_s2);
    gain_J = std::max(gain_J, now_J - first_J);
    lowest_J = std::min(lowest_J, now_J);
    regained_J = std::max(regained_J, now_J - lowest_J);
    gap_m = std::max(gap_m, widest_gap_m(scene.figure, world.states()));
    speed = 0.0;
    for (std::size_t part = 0; part < scene.models.size(); ++part) {
      speed = std::max(speed, velocity(scene.models[part], world.states()[part]).norm());
    }
  }
  EXPECT_LE(gain_J, 1e-9 * std::abs(first_J));
  EXPECT_LT(gap_m, 1e-10);
  EXPECT_LT(speed, kRestingSteps * 9.81 * kStep_s) << "still moving";
  // What gravity gives in a step to what lies still (motion.hpp).
  double mass_kg = 0.0;
  for (const BodyModel& part : scene.models) {
    mass_kg += 1.0 / part.inverse_mass;
  }
  EXPECT_LT(regained_J, (kRestingSteps + 0.5) * mass_kg * 9.81 * 9.81 * kStep_s * kStep_s);
}

}  // namespace impetus::figure_contacts_test
