// Where the bodies of a crowd start, and how they move: the same for our engine and for its peers.
//
// Bodies are put one to a cell of a grid, turned at random, and where their finest nodes touch
// nobody else's as far as some tries can find such a place. Speeds are a bounding radius in ten
// steps of 1/120 s.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "engine/numerics/random_stream.hpp"
#include "tests/bench/crowd_shape.hpp"

namespace impetus {

inline constexpr double kCrowdStep_s = 1.0 / 120.0;
inline constexpr double kCrowdSpeed_m_s = 12.0;  ///< of bodies of radius 1 m

struct BenchCrowdStart {
  double half_edge_m{0.0};  ///< of the closed cube about the origin; 0: there are no walls
  std::vector<BodyState> states;
  int touching{0};  ///< bodies that no place without contact was found for
  Vector3 gravity_m_s2{Vector3::Zero()};
};

/// `bodies` in a cube whose volume they fill by `fill`, counted as bounding spheres, flying in
/// random directions at the speed above and turning at up to as fast.
BenchCrowdStart flying(const CrowdShape& shape, int bodies, double fill);

/// Places of a cube that is 10 % full, without walls, all aimed at the middle and as fast as it
/// takes to be there together, after 96 steps.
BenchCrowdStart imploding(const CrowdShape& shape, int bodies);

/// The places of flying(), at rest: for gravity to pile them up on the floor of the cube.
BenchCrowdStart at_rest(const CrowdShape& shape, int bodies, double fill);

/// At rest in a cube, 30 % full, and then under gravity: they pile up on its floor.
BenchCrowdStart falling(const CrowdShape& shape, int bodies);

Vector3 random_in_unit_cube(RandomStream& random);
Vector3 random_direction(RandomStream& random);
Quaternion random_orientation(RandomStream& random);

}  // namespace impetus
