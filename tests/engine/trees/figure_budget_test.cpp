// The budget of a step in which there are figures.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>

#include "engine/trees/builders/build_tree.hpp"
#include "tests/engine/figure_scenes.hpp"

namespace impetus::figure_budget_test {

/// Four figures of 16 parts that fall into each other in a small cube; each part has a tree.
World crowd_of_figures(std::int64_t hinged_response) {
  FigureScene limbs = limbs_of_16();
  TriangleMesh mesh = small_l_block();
  const auto tree = std::make_shared<const VolumeTree>(build_tree(mesh, {TreeKind::kOctree, 3, 8}));
  std::vector<BodyModel> models;
  std::vector<BodyState> states;
  WorldSettings settings;
  RandomStream random(2, "crowd of figures");
  for (std::int32_t i = 0; i < 4; ++i) {
    Figure figure = limbs.figure;
    figure.first_part = 16 * i;
    for (Hinge& hinge : figure.hinges) {
      hinge.child += 16 * i;
      hinge.parent += 16 * i;
    }
    settings.figures.push_back(figure);
    for (const BodyModel& part : limbs.models) {
      models.push_back(part);
      models.back().tree = tree;
    }
    const Pose root{random_in_cube(random, 0.5), random_turn(random)};
    const std::vector<BodyState> own =
        states_of(figure, models, poses_of(figure, root, rest_angles(figure)), -2.0 * root.position,
                  Vector3::Zero());
    states.insert(states.end(), own.begin(), own.end());
  }
  settings.enclosure = Enclosure{ClosedCube{1.5}};
  settings.costs = kAllPhases;
  settings.costs.hinged_response = hinged_response;
  return World(std::move(models), std::move(states), std::move(settings));
}

TEST(FigureBudget, WhatIsSpentAndReservedNeverExceedsTheGrantOrTheFloor) {
  World world = crowd_of_figures(kAllPhases.hinged_response);
  std::int64_t over_floor = 0;
  std::size_t collisions = 0;
  for (int step = 0; step < 240; ++step) {
    FixedWork work(50'000);
    const StepReport& report = world.step({kStep_s, {}}, work);
    EXPECT_LE(report.work_peak, std::max(report.work_granted, report.work_floor));
    EXPECT_LE(report.work_spent, std::max(report.work_granted, report.work_floor));
    over_floor += report.work_spent > report.work_floor ? 1 : 0;
    collisions += report.collisions.size();
  }
  EXPECT_GT(over_floor, 10);
  EXPECT_GT(collisions, 1000U);
}

TEST(FigureBudget, ContactsWithPartsAreCountedAtTheirOwnCost) {
  const auto spent = [](std::int64_t hinged_response) {
    World world = crowd_of_figures(hinged_response);
    FixedWork work(kUnlimitedTests);
    std::int64_t contacts = 0;
    std::int64_t units = 0;
    for (int step = 0; step < 60; ++step) {
      const StepReport& report = world.step({kStep_s, {}}, work);
      contacts += static_cast<std::int64_t>(report.contacts.size());
      units += report.work_spent;
    }
    return std::pair(units, contacts);
  };
  const auto [without, contacts] = spent(0);
  const auto [with, same_contacts] = spent(1000);
  EXPECT_EQ(same_contacts, contacts);
  EXPECT_LE(with - without, 1000 * contacts);  // folds are in the floor
  EXPECT_GT(with - without, 500 * contacts);
}

}  // namespace impetus::figure_budget_test
