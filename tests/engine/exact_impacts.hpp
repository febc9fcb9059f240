// Random impacts of mesh solids at the instant of first touch, with the exact answer, and how far
// from it the engine's contacts are at each level.
//
//   a random line, turns and spins --conservative advancement--> first touch of the surfaces
//   the closest points just before --> exact normal and point --> exact velocities after it
//
// Bodies travel straight and unturned until they touch; their spins count at the impact alone. Then
// they are moved on by so little that the surfaces cross: bounds that cover them must overlap.
// (Mirtich 1996 for the advancement)
// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/collision/contact_model.hpp"
#include "engine/dynamics/impulse.hpp"
#include "engine/shapes/mesh_distance.hpp"
#include "engine/shapes/solids/ball_meshes.hpp"
#include "engine/shapes/solids/block_meshes.hpp"
#include "engine/shapes/solids/creature_mesh.hpp"
#include "engine/shapes/solids/ring_meshes.hpp"
#include "engine/trees/builders/build_tree.hpp"
#include "tests/engine/builders.hpp"
#include "tests/engine/mesh_oracles.hpp"
#include "tests/engine/once.hpp"

namespace impetus {

/// A solid of 1,000 kg/m³ about its centre of mass.
struct ImpactSolid {
  std::string name;
  TriangleMesh mesh;
  MassProperties mass;
  double radius_m{0.0};  ///< about the centre of mass
};

inline ImpactSolid impact_solid(std::string name, TriangleMesh mesh) {
  ImpactSolid solid{std::move(name), about_centre_of_mass(std::move(mesh)), {}, 0.0};
  solid.mass = solid_of(solid.mesh, 1'000.0);
  for (const Vector3& vertex : solid.mesh.vertices) {
    solid.radius_m = std::max(solid.radius_m, vertex.norm());
  }
  return solid;
}

/// Convex and not, round and angular, all of about the same size.
inline std::vector<ImpactSolid> impact_solids() {
  return {impact_solid("box", box_mesh({0.2, 0.14, 0.08})),
          impact_solid("L-block", l_block_mesh(0.2, 0.07)),
          impact_solid("creature", creature_mesh(0.25, 8)),
          impact_solid("icosphere", icosphere_mesh(0.1, 2)),
          impact_solid("torus", torus_mesh(0.08, 0.03, 20, 10))};
}

/// Two bodies that have just touched, and what is exactly true of it.
struct KnownImpact {
  std::size_t solid_a{0};
  std::size_t solid_b{0};
  std::vector<BodyState> states;  ///< of a and b, before the response
  TouchPoint touch;               ///< exact: normal from b to a
  double approach_m_s{0.0};       ///< along the normal
};

inline BodyModel impact_model(const ImpactSolid& solid, std::shared_ptr<const VolumeTree> tree) {
  BodyModel model;
  model.name = solid.name;
  model.tree = std::move(tree);
  model.inverse_mass = 1.0 / solid.mass.mass_kg;
  model.inverse_inertia = solid.mass.inertia.inverse();
  return model;
}

/// Moves `pose` along `direction` (unit) until its mesh is within `gap_m` of the other, and returns
/// the closest points; none when it passes by.
inline std::optional<FirstTouch> advance_to_touch(const ImpactSolid& a, Pose& pose,
                                                  const Vector3& direction, const ImpactSolid& b,
                                                  const Pose& pose_b, double gap_m) {
  const auto moved = [&](double way_m) {
    return Pose{pose.position + way_m * direction, pose.orientation};
  };
  const double way_to_b_m = (pose_b.position - pose.position).dot(direction);
  const auto found =
      first_touch([&](double way_m) { return mesh_distance(a.mesh, moved(way_m), b.mesh, pose_b); },
                  gap_m, way_to_b_m + a.radius_m + b.radius_m);
  pose = moved(found ? found->way_m : 0.0);
  return found;
}

/// An impact of two of `solids`, none when the bodies pass by or only graze.
inline std::optional<KnownImpact> try_impact(RandomStream& random,
                                             const std::vector<ImpactSolid>& solids) {
  constexpr double kLeastApproach = 0.2;  // of the speed: what touches more sidelong grazes
  constexpr double kGap = 1e-7;           // of the size
  KnownImpact impact;
  impact.solid_a = random.below(solids.size());
  impact.solid_b = random.below(solids.size());
  const ImpactSolid& a = solids[impact.solid_a];
  const ImpactSolid& b = solids[impact.solid_b];
  const double reach_m = a.radius_m + b.radius_m;
  const Vector3 direction = random_direction(random);
  const Vector3 aside = random_in_cube(random, 0.5 * reach_m);
  BodyState of_a = resting_at(aside - direction.dot(aside) * direction - reach_m * direction);
  BodyState of_b;
  of_a.pose.orientation = random_turn(random);
  of_b.pose.orientation = random_turn(random);
  const Vector3 spin_a = random_in_cube(random, 0.5) / a.radius_m;
  const Vector3 spin_b = random_in_cube(random, 0.5) / b.radius_m;
  const auto touched = advance_to_touch(a, of_a.pose, direction, b, of_b.pose,
                                        kGap * std::min(a.radius_m, b.radius_m));
  if (!touched) {
    return std::nullopt;
  }
  const ClosestPoints* closest = &touched->closest;
  impact.touch.normal = (closest->on_a - closest->on_b) / closest->distance_m;
  impact.touch.point = 0.5 * (closest->on_a + closest->on_b);
  const double along = -impact.touch.normal.dot(direction);
  if (along < kLeastApproach) {
    return std::nullopt;
  }
  of_a.pose.position += 2.0 * closest->distance_m / along * direction;
  impact.touch.depth_m = closest->distance_m;
  const BodyModel model_a = impact_model(a, nullptr);
  const BodyModel model_b = impact_model(b, nullptr);
  of_a.linear_momentum = a.mass.mass_kg * direction;  // 1 m/s
  of_a.angular_momentum = angular_momentum_at(model_a, of_a.pose.orientation, spin_a);
  of_b.angular_momentum = angular_momentum_at(model_b, of_b.pose.orientation, spin_b);
  impact.states = {of_a, of_b};
  impact.approach_m_s =
      -separation_speed({{0, 1}, impact.touch}, {model_a, model_b}, impact.states);
  if (impact.approach_m_s < kLeastApproach || !intersects(a.mesh, of_a.pose, b.mesh, of_b.pose)) {
    return std::nullopt;
  }
  return impact;
}

/// The next impact of the stream.
inline KnownImpact next_impact(RandomStream& random, const std::vector<ImpactSolid>& solids) {
  while (true) {
    if (std::optional<KnownImpact> impact = try_impact(random, solids)) {
      return *std::move(impact);
    }
  }
}

/// How far contacts and their response are from the exact ones.
struct KnownImpactErrors {
  double normal_rad{0.0};  ///< of the direction of the impulses' sum
  double point{0.0};       ///< of their mean place, as a share of the smaller radius
  /// Of the velocities after it, as a share of the approach: the root of the sum over both bodies
  /// of |Δv|² + (radius |Δω|)².
  double velocity{0.0};
};

inline double angle_between(const Vector3& x, const Vector3& y) {
  return std::atan2(x.cross(y).norm(), x.dot(y));
}

/// Precondition: there are contacts.
inline KnownImpactErrors errors_of(const std::vector<Contact>& contacts, const KnownImpact& impact,
                                   const std::vector<ImpactSolid>& solids,
                                   const std::vector<BodyModel>& models, double restitution) {
  const double radii_m[] = {solids[impact.solid_a].radius_m, solids[impact.solid_b].radius_m};
  std::vector<BodyState> exact = impact.states;
  respond({{{0, 1}, impact.touch}}, restitution, models, exact);
  std::vector<BodyState> found = impact.states;
  const ResponseResult result =
      respond_together(contacts, std::vector<double>(contacts.size(), restitution), models, found);
  const TouchPoint net = net_contact(contacts, result.impulse_Ns);
  double squared = 0.0;
  for (std::size_t body = 0; body < 2; ++body) {
    const BodyModel& model = models[body];
    squared += (velocity(model, found[body]) - velocity(model, exact[body])).squaredNorm() +
               radii_m[body] * radii_m[body] *
                   (angular_velocity(model, found[body]) - angular_velocity(model, exact[body]))
                       .squaredNorm();
  }
  return {angle_between(net.normal, impact.touch.normal),
          (net.point - impact.touch.point).norm() / std::min(radii_m[0], radii_m[1]),
          std::sqrt(squared) / impact.approach_m_s};
}

/// The errors of `reductions` at each of the first `levels` levels: [reduction][level].
inline std::vector<std::vector<KnownImpactErrors>> errors_by_level(
    const KnownImpact& impact, const std::vector<ImpactSolid>& solids,
    const std::vector<BodyModel>& models, const std::vector<ContactModel>& reductions, int levels,
    double restitution) {
  PlacedTree of_a(*models[0].tree);
  PlacedTree of_b(*models[1].tree);
  of_a.move_to(impact.states[0].pose);
  of_b.move_to(impact.states[1].pose);
  const auto motion = [&](std::size_t body) {
    const BodyState& state = impact.states[body];
    return BodyMotion{state.pose.position, velocity(models[body], state),
                      angular_velocity(models[body], state)};
  };
  const MovingTree a{of_a, motion(0)};
  const MovingTree b{of_b, motion(1)};
  const NormalFallbacks fallbacks{a.motion.centre_of_mass - b.motion.centre_of_mass,
                                  b.motion.velocity - a.motion.velocity};
  std::vector<std::vector<KnownImpactErrors>> errors(reductions.size());
  PairRefinement pair(of_a, of_b);
  for (int level = 0; level < levels; ++level) {
    while (pair.level() < level && !pair.resolved()) {
      pair.refine_one_block();
    }
    for (std::size_t i = 0; i < reductions.size(); ++i) {
      const std::vector<Contact> contacts =
          pair_contacts({0, 1}, pair, a, b, fallbacks, reductions[i]);
      EXPECT_FALSE(contacts.empty()) << "surfaces that cross are separate at level " << level;
      if (!contacts.empty()) {
        errors[i].push_back(errors_of(contacts, impact, solids, models, restitution));
      }
    }
  }
  return errors;
}

}  // namespace impetus
