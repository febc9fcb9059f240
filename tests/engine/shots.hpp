// Bullets and plates, and whether one got through the other.
// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "engine/collision/entry/body_path.hpp"
#include "engine/shapes/solids/block_meshes.hpp"
#include "engine/trees/builders/build_tree.hpp"
#include "tests/engine/builders.hpp"

namespace impetus {

inline constexpr double kThickness_m = 0.01;
inline constexpr double kSide_m = 0.2;
inline constexpr double kBullet_m = 0.004;

/// The same plate in a tree of the kind, built once.
inline std::shared_ptr<const VolumeTree> plate_tree(const std::string& kind) {
  static std::map<std::string, std::shared_ptr<const VolumeTree>> built;
  auto& tree = built[kind];
  if (tree == nullptr) {
    const TriangleMesh mesh = box_mesh({kSide_m, kSide_m, kThickness_m});
    const int branching = kind == "voxel" || kind == "octree" ? 8 : 6;
    tree = std::make_shared<VolumeTree>(build_tree(mesh, {tree_kind(kind), 3, branching}));
  }
  return tree;
}

inline BodyModel plate(const std::string& kind, bool movable = true) {
  const MassProperties mass = solid_of(box_mesh({kSide_m, kSide_m, kThickness_m}), 1'000.0);
  BodyModel model;
  model.name = "plate";
  model.tree = plate_tree(kind);
  if (movable) {
    model.inverse_mass = 1.0 / mass.mass_kg;
    model.inverse_inertia = mass.inertia.inverse();
  }
  return model;
}

inline BodyModel bullet() { return ball(kBullet_m, 0.01); }

inline WorldSettings handled(Tunnelling tunnelling, double restitution = 1.0) {
  WorldSettings settings;
  settings.tunnelling = tunnelling;
  settings.restitution = restitution;
  return settings;
}

/// Moments of a step, the denser the nearer to its ends: something that fast is near its target
/// only just before it hits and just after.
inline std::vector<double> moments_of_step() {
  std::vector<double> moments{0.0, 1.0};
  for (double octave = 0.5; octave > 1e-9; octave *= 0.5) {
    for (int part = 0; part < 128; ++part) {
      const double time = octave * (1.0 - part / 256.0);
      moments.push_back(time);
      moments.push_back(1.0 - time);
    }
  }
  std::sort(moments.begin(), moments.end());
  return moments;
}

/// Whether the middle of body `bullet` crosses the middle of the plate on the ways both took.
/// Dense in time, and exact when the plate does not turn.
inline bool passes(const std::vector<BodyState>& before, const std::vector<BodyState>& after,
                   std::size_t bullet, std::size_t plate) {
  static const std::vector<double> kMoments = moments_of_step();
  const BodyPath of_bullet{before[bullet].pose, after[bullet].pose};
  const BodyPath of_plate{before[plate].pose, after[plate].pose};
  const auto seen_from_plate = [&](double time) {
    const Pose pose = pose_at(of_plate, time);
    return Vector3(pose.orientation.conjugate() *
                   (pose_at(of_bullet, time).position - pose.position));
  };
  Vector3 last = seen_from_plate(0.0);
  const bool turns = !(of_plate.start.orientation.coeffs() == of_plate.end.orientation.coeffs());
  for (const double time : turns ? kMoments : std::vector<double>{1.0}) {
    const Vector3 now = seen_from_plate(time);
    if ((last.z() < 0.0) != (now.z() < 0.0)) {
      const Vector3 crossing = last + last.z() / (last.z() - now.z()) * (now - last);
      if (std::max(std::abs(crossing.x()), std::abs(crossing.y())) < 0.5 * kSide_m) {
        return true;
      }
    }
    last = now;
  }
  return false;
}

/// What became of one shot.
struct Shot {
  int passed{0};
  int stopped{0};
  int touched{0};
  double energy_gained{0.0};  ///< of the start's, by the first impact
  double momentum_lost{0.0};  ///< of all momentum there is
};

inline Shot shoot(World world, int steps) {
  Shot shot;
  const double energy = total_energy(world);
  const Vector3 momentum = total_momentum(world);
  double all = 0.0;
  for (const BodyState& state : world.states()) {
    all += state.linear_momentum.norm();
  }
  for (int step = 0; step < steps; ++step) {
    const std::vector<BodyState> before = world.states();
    const StepReport report = step_whole(world, 1.0);
    for (std::size_t body = 1; body < before.size(); ++body) {
      shot.passed += passes(before, world.states(), body, 0) ? 1 : 0;
    }
    shot.stopped += static_cast<int>(report.stopped.size());
    if (shot.touched == 0) {  // later, a plate that turns drifts by its integrator
      shot.energy_gained = total_energy(world) / energy - 1.0;
    }
    shot.touched += static_cast<int>(report.collisions.size());
    EXPECT_EQ((report.degradations & kStoppedShort) != 0, !report.stopped.empty());
  }
  shot.momentum_lost = (total_momentum(world) - momentum).norm() / all;
  return shot;
}

/// A bullet that hits a plate at rest: `speed` in thicknesses a step, under an angle, somewhere.
inline World shot_at_plate(RandomStream& random, const BodyModel& target, double speed,
                           const WorldSettings& settings, double least_cosine = 0.05) {
  const Vector3 place(uniform_in(random, -0.4, 0.4) * kSide_m,
                      uniform_in(random, -0.4, 0.4) * kSide_m, 0.0);
  Vector3 direction = random_direction(random);
  direction.z() = -uniform_in(random, least_cosine, 1.0);
  direction.normalize();
  const double clear_m = 4.0 * kThickness_m / -direction.z();
  const double way_m = speed * kThickness_m;
  const double distance_m = clear_m + random.uniform() * way_m;
  const BodyModel model = bullet();
  BodyState state = moving(model, place - distance_m * direction, way_m * direction);
  BodyState at_rest;
  const Quaternion turn = random_turn(random);
  const Vector3 where = random_in_cube(random, 1.0);
  for (BodyState* each : {&state, &at_rest}) {
    each->pose.position = where + turn * each->pose.position;
    each->linear_momentum = turn * each->linear_momentum;
  }
  at_rest.pose.orientation = turn;
  return {{target, model}, {at_rest, state}, settings};
}

inline int steps_for(double speed) { return speed < 1.0 ? 120 : 25; }

}  // namespace impetus
