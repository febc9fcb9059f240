// Spheres of a body at a random pose, as they lie in the world.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "engine/collision/sphere_block.hpp"
#include "tests/engine/builders.hpp"

namespace impetus {

/// A block of spheres, up to 2 cm large and about 10 cm from the centre of mass.
struct BodyOfSpheres {
  BodyOfSpheres(RandomStream& random, const Vector3& about) {
    pose.position = about + random_in_cube(random, 0.05);
    pose.orientation = random_turn(random);
    for (int i = 0; i < kLanes; ++i) {
      const Sphere sphere{pose.position + random_in_cube(random, 0.1), 0.02 * random.uniform()};
      reach_m = std::max(reach_m, (sphere.centre - pose.position).norm() + sphere.radius_m);
      spheres.add(sphere);
    }
  }
  Pose pose;
  SphereArrays spheres;
  double reach_m{0.0};
};

}  // namespace impetus
