// SPDX-License-Identifier: MIT
#include "engine/world/starting_overlaps.hpp"

#include "engine/collision/pair_refinement.hpp"

namespace impetus::inline world {
namespace {

bool touches(PairRefinement pair) {
  while (!pair.resolved()) {
    pair.refine_one_block();
  }
  return !pair.overlapping().empty();
}

}  // namespace

std::vector<BodyPair> overlapping_at_start(const World& world, int level) {
  std::vector<PlacedTree> placed;
  for (std::size_t body = 0; body < world.models().size(); ++body) {
    placed.emplace_back(*world.models()[body].tree);
    placed.back().move_to(world.states()[body].pose);
  }
  const auto& enclosure = world.settings().enclosure;
  std::vector<BodyPair> found;
  for (std::size_t a = 0; a < placed.size(); ++a) {
    if (world.models()[a].passes_through) {
      continue;
    }
    const bool movable = world.models()[a].inverse_mass > 0.0;
    const auto index_a = static_cast<std::int32_t>(a);
    if (enclosure && movable && touches(PairRefinement(placed[a], *enclosure, level))) {
      found.push_back({index_a, kEnclosure});
    }
    for (std::size_t b = a + 1; b < placed.size(); ++b) {
      if (!world.models()[b].passes_through && (movable || world.models()[b].inverse_mass > 0.0) &&
          touches(PairRefinement(placed[a], placed[b], level))) {
        found.push_back({index_a, static_cast<std::int32_t>(b)});
      }
    }
  }
  return found;
}

}  // namespace impetus::inline world
