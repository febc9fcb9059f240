// A volume of each kind, for what must hold for all of them. A new kind is one line here.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "engine/volumes/volume.hpp"
#include "tests/engine/builders.hpp"

namespace impetus {

/// About `centre`, turned at random, reaching from .2 to 1 times `size_m` or so.
inline std::vector<Volume> one_of_each_kind(RandomStream& random, const Vector3& centre,
                                            double size_m) {
  const auto length = [&] { return size_m * uniform_in(random, 0.2, 0.6); };
  const Quaternion turn = random_turn(random);
  const Vector3 u = turn * Vector3(length(), 0.0, 0.0);
  const Vector3 v = turn * Vector3(0.0, length(), 0.0);
  return {Sphere{centre, length()},
          LineSwept{centre, u, length()},
          RectangleSwept{centre, u, v, length()},
          RectangleSwept{centre, Vector3::Zero(), v, length()},
          Box{centre, Vector3(length(), length(), length()), turn},
          Cube{centre, length(), turn}};
}

}  // namespace impetus
