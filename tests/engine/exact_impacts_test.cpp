// Impacts against the exact answer: of the generator, and of the situations that chapter 4 argues
// from.
// SPDX-License-Identifier: MIT
#include "tests/engine/exact_impacts.hpp"

#include <gtest/gtest.h>

#include <map>

#include "tests/engine/built_solids.hpp"
#include "tests/engine/mesh_oracles.hpp"
#include "tests/engine/once.hpp"

namespace impetus::exact_impacts_test {

constexpr std::uint64_t kSeed = 4;

TEST(ExactImpacts, TouchAtTheirExactContactAndApproachThere) {
  const std::vector<ImpactSolid> solids{impact_solid("box", box_mesh({0.2, 0.14, 0.08})),
                                        impact_solid("L-block", l_block_mesh(0.2, 0.07)),
                                        impact_solid("icosphere", icosphere_mesh(0.1, 1))};
  RandomStream random(kSeed, "touch");
  for (int trial = 0; trial < 40; ++trial) {
    const KnownImpact impact = next_impact(random, solids);
    const ImpactSolid& a = solids[impact.solid_a];
    const ImpactSolid& b = solids[impact.solid_b];
    EXPECT_NEAR(impact.touch.normal.norm(), 1.0, 1e-9);
    EXPECT_GE(impact.approach_m_s, 0.2);
    // Moved apart by as much as they were moved on and once more, the surfaces are apart.
    Pose apart = impact.states[0].pose;
    EXPECT_TRUE(intersects(a.mesh, apart, b.mesh, impact.states[1].pose));
    apart.position += 1e-6 * impact.touch.normal;
    const ClosestPoints closest = mesh_distance(a.mesh, apart, b.mesh, impact.states[1].pose);
    EXPECT_GT(closest.distance_m, 0.0) << "seed " << kSeed << ", trial " << trial;
    EXPECT_LT(closest.distance_m, 2e-6);
    EXPECT_LT((closest.on_a - impact.touch.point).norm(), 1e-3);
  }
}

TEST(ExactImpacts, BoxesWhoseTreesAreThemselvesAreExactWhateverTheReduction) {
  // A box is its own tree, exact at its only level: all that is left is the depth the bodies were
  // moved on by, 1e-7 of their size.
  const std::vector<ImpactSolid> solids{impact_solid("box", box_mesh({0.2, 0.14, 0.08}))};
  const BodyModel model =
      impact_model(solids[0], std::make_shared<VolumeTree>(single_node_tree(Box{
                                  Vector3::Zero(), {0.1, 0.07, 0.04}, Quaternion::Identity()})));
  std::vector<ContactModel> reductions;
  for (const std::string_view name : reduction_names()) {
    reductions.push_back({make_reduction(name), 4});
  }
  RandomStream random(kSeed, "boxes");
  for (int trial = 0; trial < 100; ++trial) {
    const KnownImpact impact = next_impact(random, solids);
    for (const auto& levels :
         errors_by_level(impact, solids, {model, model}, reductions, /*levels=*/1, 0.5)) {
      ASSERT_LT(levels.at(0).normal_rad, 1e-5) << "seed " << kSeed << ", trial " << trial;
      ASSERT_LT(levels.at(0).point, 1e-3);
      ASSERT_LT(levels.at(0).velocity, 1e-2);
    }
  }
}

/// A body that moves against one that nothing moves, and the contacts that they exactly have.
struct Situation {
  std::vector<ImpactSolid> solids;
  KnownImpact impact;
  std::vector<Contact> exact;
};

Situation situation(ImpactSolid mover, ImpactSolid target, const Vector3& place,
                    const Quaternion& turn, const Vector3& spin,
                    const std::vector<Vector3>& exact_points) {
  Situation made{{std::move(mover), std::move(target)}, {}, {}};
  made.impact.solid_b = 1;
  BodyState state = resting_at(place);
  state.pose.orientation = turn;
  const BodyModel model = impact_model(made.solids[0], nullptr);
  state.linear_momentum = -made.solids[0].mass.mass_kg * Vector3::UnitY();  // 1 m/s downwards
  state.angular_momentum = angular_momentum_at(model, turn, spin);
  made.impact.states = {state, BodyState{}};
  for (const Vector3& point : exact_points) {
    made.exact.push_back({{0, 1}, {point, Vector3::UnitY(), 0.0}});
  }
  return made;
}

/// The error of the mover's velocity after the impact (m/s), by reduction, at the finest level of
/// octrees four deep.
std::map<std::string_view, double> velocity_errors(const Situation& of) {
  constexpr int kDepth = 4;
  constexpr double kRestitution = 0.5;
  std::vector<BodyModel> models;
  std::vector<PlacedTree> placed;
  for (const ImpactSolid& solid : of.solids) {
    models.push_back(impact_model(solid, std::make_shared<VolumeTree>(build_tree(
                                             solid.mesh, {TreeKind::kOctree, kDepth, 8}))));
    placed.emplace_back(*models.back().tree);
    placed.back().move_to(of.impact.states[placed.size() - 1].pose);
  }
  models[1].inverse_mass = 0.0;
  models[1].inverse_inertia.setZero();
  PairRefinement pair(placed[0], placed[1]);
  while (!pair.resolved()) {
    pair.refine_one_block();
  }
  const auto after = [&](const std::vector<Contact>& contacts) {
    std::vector<BodyState> states = of.impact.states;
    respond_together(contacts, std::vector<double>(contacts.size(), kRestitution), models, states);
    return states[0];
  };
  const auto velocity_of = [&](const BodyState& state) {
    Eigen::Matrix<double, 6, 1> both;
    both << velocity(models[0], state), of.solids[0].radius_m * angular_velocity(models[0], state);
    return both;
  };
  const BodyState& before = of.impact.states[0];
  const MovingTree a{
      placed[0],
      {before.pose.position, velocity(models[0], before), angular_velocity(models[0], before)}};
  std::map<std::string_view, double> errors;
  for (const std::string_view name : reduction_names()) {
    const auto contacts =
        pair_contacts({0, 1}, pair, a, {placed[1]}, {}, {make_reduction(name), 4});
    errors[name] = (velocity_of(after(contacts)) - velocity_of(after(of.exact))).norm();
  }
  return errors;
}

const TriangleMesh kPlate = box_mesh({0.3, 0.08, 0.2});

TEST(ReductionOrder, OnAFlatContactMeansAreBetterThanASingleNode) {
  // sec. 4.2.2: "for non-concave pairs of objects where many adjacent nodes ... are colliding ...
  // an effective solution is to average". The first is one of many nodes that met at the same time:
  // its place and normal are chance (1.46 m/s, of a change of 1.5). The average (.52) suffers from
  // nodes at the plates' sides, where they overhang; groups (.30) keep those apart; the densities
  // (.17) know which way the face looks; and the weights (.09) know which nodes are hardly solid.
  const auto errors = velocity_errors(situation(
      impact_solid("plate", kPlate), impact_solid("table", kPlate), {0.013, 0.08 - 1e-6, -0.007},
      Quaternion::Identity(), Vector3::Zero(),
      {{-0.137, 0.04, -0.107}, {-0.137, 0.04, 0.093}, {0.15, 0.04, -0.1}, {0.15, 0.04, 0.093}}));
  EXPECT_LT(errors.at("average"), 0.5 * errors.at("first"));
  EXPECT_LT(errors.at("groups"), errors.at("average"));
  EXPECT_LT(errors.at("density"), errors.at("groups"));
  EXPECT_LT(errors.at("weighted"), errors.at("groups"));
}

TEST(ReductionOrder, OnAnEdgeMeansAreBetterThanASingleNode) {
  // The edge is one patch, so groups are the average. Densities see the edge's two faces alike and
  // so its very direction; single nodes (1.97 m/s) are chance again.
  const double half_m = std::sqrt(0.5) * 0.1;
  const Quaternion tilted = Quaternion(1.0, 0.0, 0.0, std::sqrt(2.0) - 1.0).normalized();  // 45°
  const auto errors = velocity_errors(
      situation(impact_solid("bar", box_mesh({0.1, 0.1, 0.25})), impact_solid("table", kPlate),
                {0.013, 0.04 + half_m - 1e-6, 0.007}, tilted, Vector3::Zero(),
                {{0.013, 0.04, -0.1}, {0.013, 0.04, 0.1}}));
  for (const char* name : {"average", "groups", "density", "weighted"}) {
    EXPECT_LT(errors.at(name), 0.5 * errors.at("first")) << name;
  }
  EXPECT_LT(errors.at("density"), errors.at("average"));
}

TEST(ReductionOrder, OfTwoPatchesGroupsKeepBothWhereTheAverageIsOnNeither) {
  // A plank that turns as it falls on two feet: exact contacts at both feet stop the turning, the
  // average's one contact between them cannot. (sec. 4.2.2: "disjoint groups of colliding nodes")
  const TriangleMesh foot = box_mesh({0.1, 0.08, 0.2});
  ImpactSolid feet{
      "feet", together(moved(foot, {-0.15, 0, 0}), moved(foot, {0.15, 0, 0})), {}, 0.25};
  feet.mass = solid_of(feet.mesh, 1'000.0);
  std::vector<Vector3> corners;
  for (const double x : {-0.2, -0.1, 0.1, 0.2}) {
    corners.emplace_back(x, 0.04, -0.1);
    corners.emplace_back(x, 0.04, 0.1);
  }
  const auto errors = velocity_errors(situation(impact_solid("plank", box_mesh({0.5, 0.08, 0.3})),
                                                feet, {0.0, 0.08 - 1e-6, 0.0},
                                                Quaternion::Identity(), {0.0, 0.0, 4.0}, corners));
  for (const char* name : {"groups", "density", "weighted"}) {
    EXPECT_LT(errors.at(name), 0.1 * errors.at("average")) << name;
    EXPECT_LT(errors.at(name), 0.1 * errors.at("first")) << name;
  }
}

}  // namespace impetus::exact_impacts_test
