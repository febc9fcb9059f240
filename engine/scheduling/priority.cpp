// SPDX-License-Identifier: MIT
#include "engine/scheduling/priority.hpp"

namespace impetus::inline scheduling {

Vector3 collision_place(const PairBounds& bounds) {
  return touch(bounds.a, bounds.b, Vector3::UnitX()).point;
}

}  // namespace impetus::inline scheduling
