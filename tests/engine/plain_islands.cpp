// Islands as lists of their own.
// SPDX-License-Identifier: MIT
#include "tests/engine/plain_response.hpp"

#include <limits>

#include "engine/numerics/disjoint_sets.hpp"

namespace impetus::plain {
std::vector<std::vector<std::size_t>> islands_of(const std::vector<Contact>& contacts,
                                                 const std::vector<BodyModel>& models) {
  const auto can_move = [&](std::int32_t body) {
    return !is_wall(body) && models[static_cast<std::size_t>(body)].inverse_mass > 0.0;
  };
  DisjointSets sets(models.size());
  for (const Contact& contact : contacts) {
    const auto& [a, b] = contact.bodies;
    if (can_move(a) && can_move(b)) {
      sets.join(static_cast<std::size_t>(a), static_cast<std::size_t>(b));
    }
  }
  constexpr auto kNone = std::numeric_limits<std::size_t>::max();
  std::vector<std::size_t> island_of_set(models.size(), kNone);
  std::vector<std::vector<std::size_t>> islands;
  for (std::size_t contact = 0; contact < contacts.size(); ++contact) {
    const auto& [a, b] = contacts[contact].bodies;
    const std::int32_t mover = can_move(a) ? a : b;
    if (!can_move(mover)) {
      continue;
    }
    std::size_t& island = island_of_set[sets.name_of(static_cast<std::size_t>(mover))];
    if (island == kNone) {
      island = islands.size();
      islands.emplace_back();
    }
    islands[island].push_back(contact);
  }
  return islands;
}

}  // namespace impetus::plain
