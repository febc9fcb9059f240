// Gravity: parabolas to rounding, bounces that gain nothing, piles that lie still and stay inside.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "tests/engine/builders.hpp"

namespace impetus::gravity_test {

constexpr std::uint64_t kSeed = 1687;
const Vector3 kGravity_m_s2(0.0, -9.81, 0.0);

WorldSettings falling(double restitution) {
  WorldSettings settings;
  settings.restitution = restitution;
  settings.gravity_m_s2 = kGravity_m_s2;
  return settings;
}

/// Kinetic and potential.
double energy_J(const World& world) {
  double sum = total_energy(world);
  for (std::size_t body = 0; body < world.models().size(); ++body) {
    const double inverse_mass = world.models()[body].inverse_mass;
    if (inverse_mass > 0.0) {
      sum -= kGravity_m_s2.dot(world.states()[body].pose.position) / inverse_mass;
    }
  }
  return sum;
}

TEST(Gravity, ABodyInFlightFollowsItsParabolaToRounding) {
  // x = x₀ + v₀ t + g t²/2, P = m (v₀ + g t)
  RandomStream random(kSeed, "parabolas");
  for (int trial = 0; trial < 20; ++trial) {
    const BodyModel model = ball(0.1, uniform_in(random, 0.1, 5.0));
    const Vector3 start = random_in_cube(random, 2.0);
    const Vector3 velocity_m_s = random_in_cube(random, 5.0);
    World world({model}, {moving(model, start, velocity_m_s)}, falling(1.0));
    constexpr int kSteps = 480;
    for (int step = 0; step < kSteps; ++step) {
      step_whole(world);
    }
    const double t = kSteps * kStep_s;
    const Vector3 expected = start + t * velocity_m_s + 0.5 * t * t * kGravity_m_s2;
    // Some 1,000 sums of numbers up to 20 m, each rounded by 2e-15 of its size.
    ASSERT_LE((world.states()[0].pose.position - expected).norm(), 1e-11) << "seed " << kSeed;
    const Vector3 momentum = (velocity_m_s + t * kGravity_m_s2) / model.inverse_mass;
    ASSERT_LE((world.states()[0].linear_momentum - momentum).norm(), 1e-10 * momentum.norm());
  }
}

TEST(Gravity, WhatNothingMovesDoesNotFallAndAHoldStopsTime) {
  const BodyModel model = ball(0.1, 1.0);
  BodyState fixed = resting_at({5.0, 0.0, 0.0});
  BodyState held = resting_at({0.0, 0.0, 0.0});
  held.held_s = 2.5 * kStep_s;
  World world({fixed_ball(0.1), model}, {fixed, held}, falling(1.0));
  for (int step = 0; step < 10; ++step) {
    step_whole(world);
  }
  EXPECT_EQ(world.states()[0].pose.position, fixed.pose.position);
  EXPECT_EQ(world.states()[0].linear_momentum, Vector3(0.0, 0.0, 0.0));
  const double fallen_s = 7.5 * kStep_s;
  EXPECT_NEAR(world.states()[1].pose.position.y(), -0.5 * 9.81 * fallen_s * fallen_s, 1e-15);
  EXPECT_NEAR(world.states()[1].linear_momentum.y(), -9.81 * fallen_s, 1e-14);
}

TEST(Gravity, ABouncingBallGainsNoEnergyButWhatItsSupportedStepsMayGive) {
  // A supported step may give (kRestingSteps + ½) m g² dt², and nothing else gives anything.
  for (const double restitution : {0.0, 0.5, 0.9, 1.0}) {
    const BodyModel model = ball(0.1, 1.0);
    WorldSettings settings = falling(restitution);
    settings.enclosure = ClosedCube{1.0};
    World world({model}, {moving(model, {0.0, 0.5, 0.0}, {0.0, 0.0, 0.0})}, settings);
    const double start_J = energy_J(world);
    const double supported_J =
        (kRestingSteps + 0.5) * kGravity_m_s2.squaredNorm() * kStep_s * kStep_s;
    double before_J = start_J;
    bool touched = false;
    for (int step = 0; step < 2'400; ++step) {
      const StepReport report = step_whole(world);
      const double gain_J = energy_J(world) - before_J;
      ASSERT_LE(gain_J, (touched ? supported_J : 0.0) + 1e-13) << restitution << ", " << step;
      before_J = energy_J(world);
      touched = !report.collisions.empty();
    }
    if (restitution == 1.0) {
      EXPECT_NEAR(before_J, start_J, 1e-11) << "every bounce on its parabola";
    } else {
      EXPECT_LT(before_J, start_J - 1.0) << "it came to rest";
    }
  }
}

TEST(Gravity, WhatTouchesABodyFromTheSideDoesNotKeepItFromFalling) {
  // A ball flies to and fro between two walls while it falls; its energy is kept by every bounce.
  const BodyModel model = ball(0.1, 1.0);
  const auto gain_J = [&](int recording_format) {
    WorldSettings settings = falling(1.0);
    settings.enclosure = ClosedCube{1.0};
    settings.recording_format = recording_format;
    World world({model}, {moving(model, {0.0, 0.8, 0.0}, {20.0, 0.0, 0.0})}, settings);
    const double start_J = energy_J(world);
    int touches = 0;
    for (int step = 0; step < 130; ++step) {
      touches += step_whole(world).collisions.empty() ? 0 : 1;
    }
    EXPECT_GE(touches, 4);
    return energy_J(world) - start_J;
  };
  EXPECT_NEAR(gain_J(kRecordingFormat), 0.0, 1e-10);
  // ½ m g² dt² at each touch.
  EXPECT_GT(gain_J(2), 3 * 0.5 * kGravity_m_s2.squaredNorm() * kStep_s * kStep_s);
}

TEST(Gravity, ElasticBallsAmongEachOtherGainLittle) {
  // At each touch from below up to (kRestingSteps + ½) m g² dt² may be gained; seldom is.
  RandomStream random(kSeed, "elastic");
  const BodyModel model = ball(0.15, 1.0);
  std::vector<BodyState> states;
  for (int i = 0; i < 8; ++i) {
    const Vector3 corner(i % 2 - 0.5, i / 2 % 2 - 0.5, i / 4 - 0.5);
    states.push_back(moving(model, corner, random_in_cube(random, 1.0)));
  }
  const auto share_gained = [&](int recording_format) {
    WorldSettings settings = falling(1.0);
    settings.enclosure = ClosedCube{0.8};
    settings.recording_format = recording_format;
    World world(std::vector<BodyModel>(states.size(), model), states, settings);
    const double start_J = energy_J(world);
    FixedWork meter(kUnlimitedTests);
    for (int step = 0; step < 600; ++step) {
      world.step(step_of(1.0 / 30.0), meter);
    }
    const double fall_J = 8.0 * kGravity_m_s2.norm() * 1.6;  // of all, from top to bottom
    return (energy_J(world) - start_J) / fall_J;
  };
  // Of three seeds .02 to .04, where it was .37 to .43.
  EXPECT_LT(share_gained(kRecordingFormat), 0.05);
  EXPECT_GT(share_gained(2), 0.3) << "what recordings of format 2 were made by";
}

TEST(Gravity, AStackAtRestStaysWhereItIs) {
  const BodyModel model = ball(0.1, 1.0);
  std::vector<BodyState> states;
  for (int i = 0; i < 4; ++i) {
    states.push_back(resting_at({0.0, -0.901 + 0.199 * i, 0.0}));
  }
  for (const ResponseMethod method : {ResponseMethod::kInTurn, ResponseMethod::kTogether}) {
    WorldSettings settings = falling(0.5);
    settings.enclosure = ClosedCube{1.0};
    settings.response = method;
    World world(std::vector<BodyModel>(4, model), states, settings);
    step_whole(world);  // the one after which it is known who touches
    const std::vector<BodyState> before = world.states();
    for (int step = 1; step < 2'400; ++step) {
      step_whole(world);
    }
    for (std::size_t body = 0; body < before.size(); ++body) {
      const Vector3 moved = world.states()[body].pose.position - before[body].pose.position;
      // A millionth of the radius in ten seconds.
      EXPECT_LE(moved.norm(), 1e-7) << "body " << body << " moved by " << moved.transpose();
    }
  }
}

/// `count` L-blocks above each other in a narrow pit, falling into it.
World poured(int count, WorldSettings settings) {
  RandomStream random(kSeed, "poured");
  const BodyModel model = solid_body(small_l_block(), /*depth=*/2);
  constexpr double kHalfEdge_m = 1.0;
  std::vector<BodyState> states;
  for (int i = 0; i < count; ++i) {
    const Vector3 place(0.45 * (i % 4) - 0.675, -0.7 + 0.3 * (i / 16), 0.45 * (i / 4 % 4) - 0.675);
    states.push_back(moving(model, place, random_in_cube(random, 0.2)));
    states.back().pose.orientation = random_turn(random);
  }
  settings.enclosure = ClosedCube{kHalfEdge_m};
  return {std::vector<BodyModel>(static_cast<std::size_t>(count), model), std::move(states),
          std::move(settings)};
}

TEST(Gravity, AHundredBodiesPouredIntoAPitSettleAndNoneFallsThroughTheFloor) {
  for (const int passes : {kUnlimitedPasses, 10}) {
    WorldSettings settings = falling(0.3);
    settings.most_response_passes = passes;
    World world = poured(100, settings);
    const double start_J = energy_J(world);
    for (int step = 0; step < 840; ++step) {
      ASSERT_EQ(step_whole(world).degradations & kNotFinite, 0U);
    }
    double fastest_m_s = 0.0;
    double lowest_m = 0.0;
    for (std::size_t body = 0; body < world.states().size(); ++body) {
      fastest_m_s =
          std::max(fastest_m_s, velocity(world.models()[body], world.states()[body]).norm());
      lowest_m = std::min(lowest_m, world.states()[body].pose.position.y());
    }
    EXPECT_GT(lowest_m, -1.0) << "the floor";
    EXPECT_LT(fastest_m_s, 0.2) << "settling";
    EXPECT_LT(energy_J(world), start_J);
  }
}

/// How far the centre of any body is beyond a wall in the worst of 150 long steps (metres).
double farthest_out_m(WorldSettings settings) {
  World world = poured(12, std::move(settings));
  FixedWork meter(kUnlimitedTests);
  double farthest_m = 0.0;
  for (int step = 0; step < 150; ++step) {
    world.step(step_of(1.0 / 20.0), meter);
    for (const BodyState& state : world.states()) {
      farthest_m = std::max(farthest_m, state.pose.position.cwiseAbs().maxCoeff() - 1.0);
    }
  }
  return farthest_m;
}

TEST(Gravity, NobodyLeavesTheWallsWhateverIsMadeOfTheContacts) {
  for (const char* reduction : {"none", "first", "average", "groups", "density", "weighted"}) {
    for (const ResponseMethod method : {ResponseMethod::kInTurn, ResponseMethod::kTogether}) {
      WorldSettings settings = falling(0.5);
      settings.response = method;
      settings.contacts.reduction = make_reduction(reduction);
      EXPECT_LE(farthest_out_m(settings), 1e-9) << reduction;
    }
  }
  WorldSettings before = falling(0.5);
  before.contacts.reduction = make_reduction("first");
  before.recording_format = 2;
  EXPECT_GT(farthest_out_m(before), 1.0) << "what recordings of format 2 were made by";
  before.recording_format = 4;
  EXPECT_GT(farthest_out_m(before), 0.01) << "turned back behind the wall";
  EXPECT_LT(farthest_out_m(before), 0.35) << "by at most the way of a step";
}

TEST(Gravity, MustBeFinite) {
  WorldSettings settings = falling(1.0);
  settings.gravity_m_s2.y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(problem_of(settings), "world: gravity must be finite");
  settings = falling(1.0);
  settings.most_response_passes = 0;
  EXPECT_EQ(problem_of(settings), "world: the response needs one pass or more, got 0");
  settings = falling(1.0);
  settings.recording_format = 0;
  EXPECT_EQ(problem_of(settings), "world: expected the rules of recording format 1 to " +
                                      std::to_string(kRecordingFormat) + ", got 0");
}

}  // namespace impetus::gravity_test
