// Larger problems for the response: heaps that are one island, and pairs that meet at many points.
// SPDX-License-Identifier: MIT
#pragma once

#include "tests/engine/response_problems.hpp"

namespace impetus {

/// Balls in a heap, each touching some of those before it at up to `points` points; all fall.
inline ResponseProblem random_heap(RandomStream& random, int balls, std::uint64_t points) {
  ResponseProblem heap;
  for (std::int32_t i = 0; i < balls; ++i) {
    heap.models.push_back(ball(0.5, uniform_in(random, 0.5, 2.0)));
    heap.states.push_back(
        moving(heap.models.back(), random_in_cube(random, 3.0), random_in_cube(random, 1.0)));
    heap.states.back().pose.orientation = random_turn(random);
    heap.states.back().angular_momentum = random_in_cube(random, 0.2);
    for (std::uint64_t left = i == 0 ? 0 : 1 + random.below(points); left > 0; --left) {
      Contact contact;
      contact.bodies = {static_cast<std::int32_t>(random.below(static_cast<std::uint64_t>(i))), i};
      if (random.below(8) == 0) {
        contact.bodies = {i, wall_index(static_cast<int>(random.below(6)))};
      }
      contact.touch.normal = random_direction(random);
      contact.touch.point = random_in_cube(random, 3.0);
      heap.contacts.push_back(contact);
      heap.restitutions.push_back(random.below(3) == 0 ? 0.0 : random.uniform());
    }
  }
  return heap;
}

/// Two balls that meet at `count` points, as two bodies of many nodes do.
inline ResponseProblem random_pair(RandomStream& random, std::uint64_t count) {
  ResponseProblem pair;
  for (const double side : {-1.0, 1.0}) {
    pair.models.push_back(ball(1.0, uniform_in(random, 0.5, 2.0)));
    pair.states.push_back(moving(pair.models.back(), {0.9 * side, 0.0, 0.0},
                                 Vector3(-side, 0.0, 0.0) + random_in_cube(random, 0.5)));
    pair.states.back().angular_momentum = random_in_cube(random, 0.5);
  }
  for (; count > 0; --count) {
    Contact contact;
    contact.bodies = {0, 1};
    contact.touch.normal = (random_in_cube(random, 0.5) - Vector3::UnitX()).normalized();
    contact.touch.point = random_in_cube(random, 0.5);
    pair.contacts.push_back(contact);
    pair.restitutions.push_back(random.uniform());
  }
  return pair;
}

}  // namespace impetus
