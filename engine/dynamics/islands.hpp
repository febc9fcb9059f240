// Groups contacts that can affect each other: those connected through bodies that can move.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "engine/dynamics/body_sets.hpp"
#include "engine/dynamics/contact_bodies.hpp"

namespace impetus::inline dynamics {

/// Indices of the contacts, island by island in the order of each island's first contact, rising
/// within an island. Bodies that nothing moves, and walls, connect nothing; a contact of none but
/// those is in no island. Keeps its arrays from one step to the next.
class Islands {
 public:
  void find(const ContactBodies& bodies);

  [[nodiscard]] std::size_t count() const { return first_.size() - 1; }
  [[nodiscard]] std::span<const std::size_t> members(std::size_t island) const {
    return {members_.data() + first_[island], first_[island + 1] - first_[island]};
  }

 private:
  std::size_t island_of(const ContactArms& contact, const ContactBodies& bodies);

  BodySets sets_{0};
  std::vector<std::size_t> island_of_set_;
  std::vector<std::size_t> island_of_contact_;
  std::vector<std::size_t> first_{0};  ///< of `members_`, by island, and their end
  std::vector<std::size_t> next_;      ///< where each island is filled
  std::vector<std::size_t> members_;
};

}  // namespace impetus::inline dynamics
