// SPDX-License-Identifier: MIT
#include "engine/dynamics/islands.hpp"

#include <limits>
#include <utility>

namespace impetus::inline dynamics {
namespace {

constexpr auto kNoIsland = std::numeric_limits<std::size_t>::max();

}  // namespace

/// Numbered as they come.
std::size_t Islands::island_of(const ContactArms& contact, const ContactBodies& bodies) {
  const std::int32_t mover = bodies.moves(contact.a) ? contact.a : contact.b;
  if (!bodies.moves(mover)) {
    return kNoIsland;
  }
  std::size_t& island = island_of_set_[sets_.name_of(static_cast<std::size_t>(mover))];
  if (island == kNoIsland) {
    island = count();
    first_.push_back(0);
  }
  return island;
}

void Islands::find(const ContactBodies& bodies) {
  sets_.separate(bodies.body_count());
  for (std::size_t i = 0; i < bodies.contact_count(); ++i) {
    const auto [a, b] = std::pair(bodies.contact(i).a, bodies.contact(i).b);
    if (!bodies.is_like_the_last(i) && bodies.moves(a) && bodies.moves(b)) {
      sets_.join(static_cast<std::size_t>(a), static_cast<std::size_t>(b));
    }
  }
  island_of_set_.assign(bodies.body_count(), kNoIsland);
  island_of_contact_.clear();
  first_.assign(1, 0);
  for (std::size_t i = 0; i < bodies.contact_count(); ++i) {
    const std::size_t island = bodies.is_like_the_last(i) ? island_of_contact_.back()
                                                          : island_of(bodies.contact(i), bodies);
    island_of_contact_.push_back(island);
    if (island != kNoIsland) {
      ++first_[island + 1];
    }
  }
  for (std::size_t island = 0; island < count(); ++island) {
    first_[island + 1] += first_[island];
  }
  members_.resize(first_.back());
  next_ = first_;
  for (std::size_t i = 0; i < island_of_contact_.size(); ++i) {
    if (island_of_contact_[i] != kNoIsland) {
      members_[next_[island_of_contact_[i]]++] = i;
    }
  }
}

}  // namespace impetus::inline dynamics
