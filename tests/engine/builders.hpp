// Small builders of what the engine's tests act on.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "engine/dynamics/centres_at_walls.hpp"
#include "engine/numerics/random_stream.hpp"
#include "engine/shapes/solids/block_meshes.hpp"
#include "engine/trees/builders/octree.hpp"
#include "engine/world/world.hpp"
#include "tests/engine/once.hpp"

namespace impetus {

inline constexpr double kStep_s = 1.0 / 240.0;

inline double uniform_in(RandomStream& random, double least, double most) {
  return least + (most - least) * random.uniform();
}

inline Vector3 random_in_cube(RandomStream& random, double half_side) {
  const double x = uniform_in(random, -half_side, half_side);
  const double y = uniform_in(random, -half_side, half_side);
  const double z = uniform_in(random, -half_side, half_side);
  return {x, y, z};
}

inline Vector3 random_direction(RandomStream& random) {
  while (true) {
    const Vector3 v = random_in_cube(random, 1.0);
    if (v.norm() > 0.1 && v.norm() <= 1.0) {
      return v.normalized();
    }
  }
}

inline Quaternion random_turn(RandomStream& random) {
  const Vector3 axis = random_direction(random);
  const double scale = uniform_in(random, -3.0, 3.0);
  return Quaternion(1.0, scale * axis.x(), scale * axis.y(), scale * axis.z()).normalized();
}

/// A solid ball of the given mass with a tree of one node.
inline BodyModel ball(double radius_m, double mass_kg) {
  BodyModel model;
  model.name = "ball";
  model.tree = std::make_shared<VolumeTree>(single_node_tree(Sphere{Vector3::Zero(), radius_m}));
  model.inverse_mass = 1.0 / mass_kg;
  model.inverse_inertia = Matrix3::Identity() / (0.4 * mass_kg * radius_m * radius_m);
  return model;
}

/// A ball that nothing moves.
inline BodyModel fixed_ball(double radius_m) {
  BodyModel model = ball(radius_m, 1.0);
  model.name = "fixed ball";
  model.inverse_mass = 0.0;
  model.inverse_inertia.setZero();
  return model;
}

/// A solid of 1,000 kg/m³ in its own frame: the mesh must be about its centre of mass.
inline BodyModel solid_body(const TriangleMesh& mesh, int depth) {
  const MassProperties mass = solid_of(mesh, 1'000.0);
  BodyModel model;
  model.name = "solid";
  model.tree = std::make_shared<VolumeTree>(octree(mesh, depth));
  model.inverse_mass = 1.0 / mass.mass_kg;
  model.inverse_inertia = mass.inertia.inverse();
  return model;
}

/// The studies' concave body at a tenth of a metre a degree.
inline TriangleMesh small_l_block() { return about_centre_of_mass(l_block_mesh(0.2, 0.07)); }

inline BodyState resting_at(const Vector3& position) {
  BodyState state;
  state.pose.position = position;
  return state;
}

/// A body whose centre moves at `velocity_m_s`.
inline BodyState moving(const BodyModel& model, const Vector3& position,
                        const Vector3& velocity_m_s) {
  BodyState state = resting_at(position);
  state.linear_momentum = velocity_m_s / model.inverse_mass;
  return state;
}

/// By how much a place is beyond the walls, at the farthest (metres); below 0: within them all.
inline double beyond_walls_m(const Enclosure& enclosure, const Vector3& place) {
  double farthest_m = -std::numeric_limits<double>::infinity();
  for (int wall = 0; wall < kWallCount; ++wall) {
    farthest_m = std::max(farthest_m, centre_beyond_m(enclosure, wall, place));
  }
  return farthest_m;
}

/// The farthest that any body's centre is beyond the walls of a world (metres); without walls:
/// -infinity.
inline double farthest_outside_m(const World& world) {
  double farthest_m = -std::numeric_limits<double>::infinity();
  for (std::size_t body = 0; world.settings().enclosure && body < world.states().size(); ++body) {
    farthest_m = std::max(farthest_m, beyond_walls_m(*world.settings().enclosure,
                                                     world.states()[body].pose.position));
  }
  return farthest_m;
}

inline StepInput step_of(double dt_s) {
  StepInput input;
  input.dt_s = dt_s;
  input.viewer = viewer_at({}, 0.0);
  input.viewer.eye = Vector3(0.0, 0.0, 10.0);
  return input;
}

/// `count` tumbling L-blocks at rest density in a closed cube that has room for 27.
inline World enclosed_l_blocks(int count, int depth, Schedule schedule = {}) {
  RandomStream random(15, "enclosed L-blocks");
  const BodyModel model = solid_body(small_l_block(), depth);
  std::vector<BodyState> states;
  for (int i = 0; i < count; ++i) {
    const Vector3 place(0.36 * (i % 3 - 1), 0.36 * (i / 3 % 3 - 1), 0.36 * (i / 9 % 3 - 1));
    states.push_back(moving(model, place, random_in_cube(random, 0.5)));
    states.back().pose.orientation = random_turn(random);
    states.back().angular_momentum = model.inverse_inertia.inverse() * random_in_cube(random, 3.0);
  }
  WorldSettings settings;
  settings.enclosure = ClosedCube{0.6};
  settings.schedule = std::move(schedule);
  return {std::vector<BodyModel>(static_cast<std::size_t>(count), model), std::move(states),
          std::move(settings)};
}

/// Spheres about these centres, in one of `reach_m` about the origin.
inline VolumeTree two_levels(const std::vector<Vector3>& centres, double radius_m, double reach_m) {
  std::vector<VolumeNode> nodes{
      {Sphere{Vector3::Zero(), reach_m}, 1, static_cast<std::int32_t>(centres.size()), {}}};
  for (const Vector3& centre : centres) {
    nodes.push_back({Sphere{centre, radius_m}, 0, 0, {}});
  }
  return {nodes, {0, 1}};
}

/// The average of the contacts of all overlapping nodes of two bodies that do not move.
/// Precondition: the pair overlaps.
inline Contact average_contact(BodyPair bodies, const PairRefinement& pair, PlacedTree& a,
                               PlacedTree& b, const NormalFallbacks& fallbacks) {
  return pair_contacts(bodies, pair, {a}, {b}, fallbacks, {}).at(0);
}

/// One step of `world` with all the work it asks for.
inline StepReport step_whole(World& world, double dt_s = kStep_s) {
  FixedWork meter(kUnlimitedTests);
  return world.step(step_of(dt_s), meter);
}

inline Vector3 total_momentum(const World& world) {
  Vector3 sum = Vector3::Zero();
  for (const BodyState& state : world.states()) {
    sum += state.linear_momentum;
  }
  return sum;
}

inline Vector3 total_angular_momentum(const World& world) {
  Vector3 sum = Vector3::Zero();
  for (const BodyState& state : world.states()) {
    sum += state.angular_momentum + state.pose.position.cross(state.linear_momentum);
  }
  return sum;
}

inline double total_energy(const World& world) {
  double sum = 0.0;
  for (std::size_t body = 0; body < world.models().size(); ++body) {
    sum += kinetic_energy(world.models()[body], world.states()[body]);
  }
  return sum;
}

/// What total_energy() would be after a step in which nobody met anybody: the momenta are the same,
/// but bodies that turn have other energies by the integrator's.
inline double energy_after_free_flight(const World& world, double dt_s) {
  std::vector<BodyState> free = world.states();
  double sum = 0.0;
  for (std::size_t body = 0; body < free.size(); ++body) {
    advance(world.models()[body], free[body], dt_s);
    sum += kinetic_energy(world.models()[body], free[body]);
  }
  return sum;
}

/// A tree of random spheres in which every child lies within its parent, of at most `levels`
/// levels. A quarter of the inner nodes end early, so that leaves meet inner nodes.
inline VolumeTree random_tree(RandomStream& random, int levels) {
  std::vector<VolumeNode> nodes{{Sphere{0.2 * random_direction(random), 1.0}, 0, 0, {}}};
  std::vector<std::int32_t> starts{0};
  for (int level = 1; level < levels; ++level) {
    const auto begin = static_cast<std::size_t>(starts.back());
    const std::size_t end = nodes.size();
    for (std::size_t parent = begin; parent < end; ++parent) {
      const bool ends_early = level > 1 && random.below(4) == 0;
      const std::uint64_t children = ends_early ? 0 : 1 + random.below(4);
      const auto outer = std::get<Sphere>(nodes[parent].volume);
      nodes[parent].child_count = static_cast<std::int32_t>(children);
      nodes[parent].first_child = static_cast<std::int32_t>(nodes.size());
      for (std::uint64_t child = 0; child < children; ++child) {
        const double radius_m = outer.radius_m * uniform_in(random, 0.4, 0.8);
        // 0.999: rounding in the world's coordinates must not push a child out of its parent.
        const double reach_m = 0.999 * (outer.radius_m - radius_m) * random.uniform();
        nodes.push_back(
            {Sphere{outer.centre + reach_m * random_direction(random), radius_m}, 0, 0, {}});
      }
    }
    if (nodes.size() == end) {
      break;
    }
    starts.push_back(static_cast<std::int32_t>(end));
  }
  return {std::move(nodes), std::move(starts)};
}

/// A body with a random tree and an inertia of three different axes.
inline BodyModel random_body(RandomStream& random, int levels) {
  BodyModel model = ball(1.0, uniform_in(random, 0.5, 2.0));
  model.name = "random body";
  model.tree = std::make_shared<VolumeTree>(random_tree(random, levels));
  const double a = uniform_in(random, 1.0, 4.0);
  const double b = uniform_in(random, 1.0, 4.0);
  const double c = uniform_in(random, 1.0, 4.0);
  model.inverse_inertia = Vector3(a, b, c).asDiagonal();
  return model;
}

/// Eight bodies of multi-level trees on the corners of a cube, flying at each other and spinning.
inline World random_tree_world(std::uint64_t seed, int levels, WorldSettings settings = {}) {
  RandomStream random(seed, "random tree world");
  std::vector<BodyModel> models;
  std::vector<BodyState> states;
  for (int corner = 0; corner < 8; ++corner) {
    const Vector3 place(corner & 1 ? 1.5 : -1.5, corner & 2 ? 1.5 : -1.5, corner & 4 ? 1.5 : -1.5);
    models.push_back(random_body(random, levels));
    BodyState state = moving(models.back(), place, random_in_cube(random, 1.0) - 0.7 * place);
    state.pose.orientation = random_turn(random);
    state.angular_momentum = random_in_cube(random, 1.0);
    states.push_back(state);
  }
  return {std::move(models), std::move(states), settings};
}

}  // namespace impetus
