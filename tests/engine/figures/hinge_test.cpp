// Hinges and the poses they make.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "engine/figures/hinged_responder.hpp"
#include "tests/engine/figure_scenes.hpp"

namespace impetus::hinge_test {

Hinge crooked_hinge(RandomStream& random) {
  Hinge hinge = end_to_end(1, 0, Vector3::UnitZ());
  const auto side = [&](HingeSide& of) {
    of.anchor = random_in_cube(random, 0.3);
    of.axis = random_direction(random);
    of.zero = of.axis.cross(random_direction(random)).normalized();
    of.core = random_direction(random);
  };
  side(hinge.of_child);
  side(hinge.of_parent);
  return hinge;
}

TEST(Hinge, AChildHangsAtTheAngleThatWasAsked) {
  RandomStream random(1, "hinges");
  for (int i = 0; i < 1000; ++i) {
    const Hinge hinge = crooked_hinge(random);
    const Pose parent{random_in_cube(random, 2.0), random_turn(random)};
    const double angle = uniform_in(random, -3.1, 3.1);
    const Pose child = hung_from(hinge, parent, angle);
    EXPECT_NEAR(angle_of(hinge, child, parent), angle, 1e-12);
    EXPECT_LT(anchor_gap_m(hinge, child, parent), 1e-14);
    EXPECT_LT((child.orientation * hinge.of_child.axis - parent.orientation * hinge.of_parent.axis)
                  .norm(),
              1e-14);
  }
}

TEST(Hinge, AnglesAreToldAboutTheMiddleOfTheLimits) {
  Hinge hinge = end_to_end(1, 0, Vector3::UnitZ());
  hinge.least_rad = 0.5;
  hinge.most_rad = kPi;
  hinge.rest_rad = 1.0;
  const Pose parent;
  EXPECT_NEAR(angle_of(hinge, hung_from(hinge, parent, 3.3), parent), 3.3, 1e-12);
  EXPECT_NEAR(angle_of(hinge, hung_from(hinge, parent, -1.2), parent), -1.2, 1e-12);
}

TEST(Hinge, FoldsPastTheThresholdFromRestAlways) {
  RandomStream random(2, "folds");
  for (int i = 0; i < 1000; ++i) {
    Hinge hinge = end_to_end(1, 0, Vector3::UnitZ());
    hinge.rest_rad = uniform_in(random, -1.0, 1.0);
    hinge.fold_rad = uniform_in(random, 0.1, 2.0);
    const Pose parent{random_in_cube(random, 1.0), random_turn(random)};
    EXPECT_FALSE(is_folded(hinge, hung_from(hinge, parent, hinge.rest_rad), parent));
    const double side = hinge.rest_rad < 0.0 ? -1.0 : 1.0;  // on towards folding
    const double threshold = hinge.rest_rad + side * hinge.fold_rad;
    EXPECT_FALSE(is_folded(hinge, hung_from(hinge, parent, threshold - side * 1e-6), parent));
    EXPECT_TRUE(is_folded(hinge, hung_from(hinge, parent, threshold + side * 1e-6), parent));
  }
}

TEST(Hinge, ATurnAboutTheOpeningAxisOpens) {
  RandomStream random(3, "openings");
  for (int i = 0; i < 1000; ++i) {
    const Hinge hinge = crooked_hinge(random);
    const Pose parent{random_in_cube(random, 2.0), random_turn(random)};
    Pose child = hung_from(hinge, parent, uniform_in(random, -3.0, 3.0));
    const double before = opening_of(hinge, child, parent);
    const Vector3 axis = opening_axis(hinge, child, parent);
    if (before > 3.1) {
      continue;
    }
    constexpr double kTurn = 1e-6;
    child.orientation =
        Quaternion(1.0, 0.5 * kTurn * axis.x(), 0.5 * kTurn * axis.y(), 0.5 * kTurn * axis.z())
            .normalized() *
        child.orientation;
    EXPECT_NEAR(opening_of(hinge, child, parent) - before, kTurn, 1e-9);
  }
}

TEST(Hinge, ImpossibleHingesAreRefusedWithTheReason) {
  const auto refused = [](auto change) {
    FigureScene scene = chain_of(3);
    change(scene.figure);
    return problem_of(scene.figure, scene.models);
  };
  EXPECT_EQ(refused([](Figure&) {}), "");
  EXPECT_EQ(refused([](Figure& figure) { figure.hinges[1].parent = 2; }),
            "figure \"chain\": expected hinge 1 to join part 2 to an earlier part");
  EXPECT_EQ(refused([](Figure& figure) { figure.part_count = 4; }),
            "figure \"chain\": expected parts among the 3 bodies");
  EXPECT_EQ(
      refused([](Figure& figure) { figure.hinges[0].of_child.axis *= 2.0; }),
      "figure \"chain\": hinge 0: expected directions of unit length on the child's side, got "
      "one of 2.000000");
  EXPECT_EQ(refused([](Figure& figure) {
              figure.hinges[0].least_rad = 0.5;
              figure.hinges[0].most_rad = 1.0;
            }),
            "figure \"chain\": hinge 0: expected a rest angle within the limits, got 0.000000 "
            "degrees");
  EXPECT_EQ(refused([](Figure& figure) { figure.driven = JointMotion{}; }),
            "figure \"chain\": expected a wave for each of 2 joints, got 0");
  FigureScene without_mass = chain_of(3);
  without_mass.models[1].inverse_mass = 0.0;
  EXPECT_EQ(problem_of(without_mass.figure, without_mass.models),
            "figure \"chain\": expected a mass and inertia of the part \"part 1\"");
  // Poses that such hinges would have are none.
  FigureScene looped = chain_of(3);
  looped.figure.hinges[1].parent = 2;
  EXPECT_THROW(poses_of(looped.figure, {}, rest_angles(looped.figure)), std::invalid_argument);
  EXPECT_THROW(poses_of(chain_of(3).figure, {}, {0.0}), std::invalid_argument);
}

TEST(Hinge, AWorldRefusesWhatFiguresCannotHave) {
  const FigureScene scene = chain_of(3);
  const auto refused = [&](auto change) {
    WorldSettings settings;
    settings.figures = {scene.figure};
    change(settings);
    try {
      const World world(scene.models, scene.at_rest(), settings);
      return std::string();
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
  };
  EXPECT_EQ(refused([](WorldSettings&) {}), "");
  EXPECT_EQ(refused([](WorldSettings& settings) { settings.imposed_hold_s = 0.1; }),
            "world: expected no imposed hold, spin or rebound where there are figures");
  EXPECT_EQ(refused([](WorldSettings& settings) { settings.response = ResponseMethod::kTogether; }),
            "world: expected impulses in turn where there are figures, got together");
  EXPECT_EQ(refused([](WorldSettings& settings) { settings.figures[0].first_part = 1; }),
            "world: figure \"chain\": expected parts among the 3 bodies");
}

TEST(Hinge, AWorldRefusesAFigureThatIsTorn) {
  const FigureScene scene = chain_of(3);
  const auto refused = [&](auto change) {
    std::vector<BodyState> states = scene.at_rest();
    change(states);
    return problem_of(std::vector{scene.figure}, scene.models, states);
  };
  EXPECT_EQ(refused([](std::vector<BodyState>&) {}), "");
  EXPECT_EQ(
      refused([](std::vector<BodyState>& states) { states[2].pose.position.y() += 0.25; }),
      "figure \"chain\": expected the two parts of hinge 1 where it joins them, got its places "
      "0.250000 m apart");
  EXPECT_EQ(refused([&](std::vector<BodyState>& states) {
              const Hinge& hinge = scene.figure.hinges[1];
              Pose& child = states[2].pose;
              const Vector3 anchor = child.transform(hinge.of_child.anchor);
              const Vector3 axis = hinge.of_child.axis.unitOrthogonal();
              child.orientation = child.orientation * Quaternion(Eigen::AngleAxisd(0.1, axis));
              child.position = anchor - child.orientation * hinge.of_child.anchor;
            }),
            "figure \"chain\": expected the two parts of hinge 1 to turn about one axis, got two");
}

}  // namespace impetus::hinge_test
