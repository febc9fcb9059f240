// SPDX-License-Identifier: MIT
#include "experiments/scenes/figures/figure_starts.hpp"

#include <algorithm>

namespace impetus::inline scenes {

bool are_neighbours(const Figure& figure, std::int32_t a, std::int32_t b) {
  return std::any_of(figure.hinges.begin(), figure.hinges.end(), [&](const Hinge& hinge) {
    return (hinge.child == a && hinge.parent == b) || (hinge.child == b && hinge.parent == a);
  });
}

bool leaves_out(const Figure& figure, std::int32_t a, std::int32_t b) {
  return figure.has_part(a) && figure.has_part(b) &&
         (!figure.self_collision.others || are_neighbours(figure, a, b));
}

const Hinge* folded_hinge(const Figure& figure, const std::vector<Pose>& poses) {
  if (!figure.self_collision.neighbours) {
    return nullptr;
  }
  const auto pose = [&](std::int32_t body) -> const Pose& {
    return poses[static_cast<std::size_t>(body - figure.first_part)];
  };
  const auto found = std::find_if(
      figure.hinges.begin(), figure.hinges.end(),
      [&](const Hinge& hinge) { return is_folded(hinge, pose(hinge.child), pose(hinge.parent)); });
  return found == figure.hinges.end() ? nullptr : &*found;
}

}  // namespace impetus::inline scenes
