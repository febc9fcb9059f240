// Figures whose motion is cut: they go as one body, and come back from beyond walls as wholes.
// SPDX-License-Identifier: MIT
#include "engine/figures/as_one_body.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "tests/engine/figure_flight.hpp"

namespace impetus::as_one_body_test {

// By the rules of format 5 hinges open by 1 cm here, and the energy changes by a fifth.
TEST(AsOneBody, WhateverIsCutOfItAFigureKeepsItsMomentumItsEnergyAndItsHinges) {
  for (const auto& [stirred, most_units] : {std::pair(0.02, 400), std::pair(2.0, 6'000)}) {
    const Flight flight = fly(1000, stirred, Rotation::kMidpoint, most_units);
    EXPECT_GT(flight.steps_cut, 100);
    EXPECT_LT(flight.steps_cut, 1000);
    EXPECT_LT(flight.momentum_drift, 1e-12);
    EXPECT_LT(flight.angular_drift, 1e-11);
    EXPECT_LT(flight.energy_drift, 1e-9);
    EXPECT_LT(flight.widest_gap_m, 1e-8);
  }
}

/// Of a row of spinning figures without gravity: what a step of so many units makes of them.
class Row {
 public:
  explicit Row(int count) {
    WorldSettings settings;
    std::vector<BodyModel> models;
    std::vector<BodyState> states;
    for (std::int32_t i = 0; i < count; ++i) {
      FigureScene scene = chain_of(2, /*about_z_alone=*/true);
      scene.figure.self_collision = {false, false};
      std::vector<BodyState> own =
          scene.at_rest({Vector3(0.0, 2.0 * i, 0.0), Quaternion::Identity()});
      own[1].angular_momentum = Vector3(0.0, 0.0, 0.01);
      Figures({scene.figure}, scene.models).begin({scene.figure}, own);
      scene.figure.first_part = 2 * i;
      for (Hinge& hinge : scene.figure.hinges) {
        hinge.child += 2 * i;
        hinge.parent += 2 * i;
      }
      settings.figures.push_back(scene.figure);
      models.insert(models.end(), scene.models.begin(), scene.models.end());
      states.insert(states.end(), own.begin(), own.end());
    }
    world_.emplace(models, states, settings);
  }

  /// Whose hinge turned.
  std::vector<std::size_t> step(std::int64_t units) {
    const std::vector<double> before = angles();
    WorkGrants grants;
    grants.of(WorkPhase::kMotion) = units;
    FixedWork work(grants);
    world_->step({kStep_s, {}}, work);
    std::vector<std::size_t> turned;
    for (std::size_t i = 0; i < before.size(); ++i) {
      if (std::abs(angles()[i] - before[i]) > 1e-9) {
        turned.push_back(i);
      }
    }
    return turned;
  }

 private:
  [[nodiscard]] std::vector<double> angles() const {
    std::vector<double> angles;
    for (const Figure& figure : world_->settings().figures) {
      const auto& states = world_->states();
      angles.push_back(angle_of(figure.hinges[0],
                                states[static_cast<std::size_t>(figure.first_part) + 1].pose,
                                states[static_cast<std::size_t>(figure.first_part)].pose));
    }
    return angles;
  }

  std::optional<World> world_;
};

TEST(AsOneBody, WhoCameShortIsFirstInTheNextStep) {
  Row row(3);
  using Figures = std::vector<std::size_t>;
  EXPECT_EQ(row.step(0), Figures());
  // Two parts in two iterations or three take four units or six, and then it has arrived.
  EXPECT_EQ(row.step(7), (Figures{0}));
  EXPECT_EQ(row.step(7), (Figures{1}));
  EXPECT_EQ(row.step(7), (Figures{2}));
  EXPECT_EQ(row.step(7), (Figures{0}));
  EXPECT_EQ(row.step(kUnlimitedTests), (Figures{0, 1, 2}));
}

TEST(AsOneBody, AFixedFigureOfWhichAllIsCutStandsStillAndGoesOnAsItDid) {
  FigureScene scene = chain_of(2, /*about_z_alone=*/true);
  scene.models[0].inverse_mass = 0.0;
  scene.models[0].inverse_inertia.setZero();
  scene.figure.self_collision = {false, false};
  WorldSettings settings;
  settings.figures = {scene.figure};
  settings.gravity_m_s2 = Vector3(0.0, -9.81, 0.0);
  World world(scene.models, scene.at_rest(), settings);
  FixedWork whole(0);
  world.step({kStep_s, {}}, whole);
  const BodyState falling = world.states()[1];
  World other = world;
  WorkGrants nothing;
  nothing.of(WorkPhase::kMotion) = 0;
  FixedWork cut(nothing);
  EXPECT_NE(world.step({kStep_s, {}}, cut).degradations & kMotionCut, 0U);
  EXPECT_EQ(world.states()[1].pose.position, falling.pose.position);
  EXPECT_EQ(world.states()[1].linear_momentum, falling.linear_momentum);
  EXPECT_EQ(world.step({kStep_s, {}}, whole).state.hash,
            other.step({kStep_s, {}}, whole).state.hash);
}

TEST(AsOneBody, AFigureOfWhichAllIsCutFallsAsItsCentreWould) {
  FigureScene scene = limbs_of_16();
  scene.figure.self_collision = {false, false};
  RandomStream random(9, "falls");
  std::vector<BodyState> states = scene.at_rest();
  stir(scene, 0.05, random, states);
  WorldSettings settings;
  settings.figures = {scene.figure};
  settings.gravity_m_s2 = Vector3(1.0, -9.81, 0.0);
  World world(scene.models, states, settings);
  const double before_J = energy_of(scene.models, states, settings.gravity_m_s2);
  const WholeMomentum before = momentum_of(states);
  double mass_kg = 0.0;
  for (const BodyModel& model : scene.models) {
    mass_kg += 1.0 / model.inverse_mass;
  }
  WorkGrants nothing;
  nothing.of(WorkPhase::kMotion) = 0;
  constexpr int kSteps = 100;
  for (int step = 0; step < kSteps; ++step) {
    FixedWork cut(nothing);
    world.step({kStep_s, {}}, cut);
  }
  const Vector3 gained = kSteps * kStep_s * mass_kg * settings.gravity_m_s2;
  EXPECT_LT((momentum_of(world.states()).linear - before.linear - gained).norm(), 1e-11);
  EXPECT_NEAR(energy_of(scene.models, world.states(), settings.gravity_m_s2), before_J,
              1e-11 * gained.squaredNorm() / mass_kg);
}

TEST(AsOneBody, OneThatIsBeyondWallsComesBackWithItsHingesAndPaysForItsHeight) {
  const FigureScene scene = limbs_of_16();
  const Enclosure walls = view_frustum(viewer_at({4.0, 3.0, 1280, 1024, 10.0}, 25.0), 2.0, 2.0);
  RandomStream random(3, "beyond walls");
  int came_back = 0;
  for (int i = 0; i < 200; ++i) {
    const Pose root{random_in_cube(random, 2.0), random_turn(random)};
    std::vector<BodyState> states =
        states_of(scene.figure, scene.models,
                  poses_of(scene.figure, root, random_angles(scene.figure, random)),
                  Vector3::Zero(), Vector3::Zero());
    stir(scene, 0.02, random, states);
    const Vector3 gravity = i % 2 == 0 ? Vector3::Zero() : random_in_cube(random, 9.0);
    const double before_J = energy_of(scene.models, states, gravity);
    const bool is_beyond = std::any_of(states.begin(), states.end(), [&](const BodyState& state) {
      return beyond_walls_m(walls, state.pose.position) > 0.0;
    });
    move_back_inside(walls, gravity, scene.models, states);
    ASSERT_LE(energy_of(scene.models, states, gravity), before_J + 1e-12);
    ASSERT_LT(widest_gap_m(scene.figure, states), 1e-12);
    if (gravity.isZero(0.0) && is_beyond) {
      ++came_back;
      for (const BodyState& state : states) {
        ASSERT_LE(beyond_walls_m(walls, state.pose.position), 1e-9) << i;
      }
    }
  }
  EXPECT_GT(came_back, 20);
}

TEST(AsOneBody, OneThatPassesThroughStaysBeyondTheWall) {
  FigureScene scene = limbs_of_16();
  for (BodyModel& part : scene.models) {
    part.passes_through = true;
  }
  std::vector<BodyState> states = scene.at_rest({Vector3(5.0, 0.0, 0.0), Quaternion::Identity()});
  move_back_inside(ClosedCube{2.0}, Vector3::Zero(), scene.models, states);
  EXPECT_EQ(states[0].pose.position, Vector3(5.0, 0.0, 0.0));
}

}  // namespace impetus::as_one_body_test
