// The response to the contacts of a step, by either method, in arrays that outlive the step.
//
//   contacts --gather--> bodies at contacts --in turn | island by island--> momenta, impulses
//
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "engine/dynamics/contact_bodies.hpp"
#include "engine/dynamics/impulse.hpp"
#include "engine/dynamics/impulses_in_turn.hpp"
#include "engine/dynamics/impulses_together.hpp"
#include "engine/numerics/disjoint_sets.hpp"

namespace impetus::inline dynamics {

/// Groups contacts that can affect each other, those connected through bodies that can move:
/// indices of the contacts, island by island in the order of each island's first contact, rising
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

  DisjointSets sets_{0};
  std::vector<std::size_t> island_of_set_;
  std::vector<std::size_t> island_of_contact_;
  std::vector<std::size_t> first_{0};  ///< of `members_`, by island, and their end
  std::vector<std::size_t> next_;      ///< where each island is filled
  std::vector<std::size_t> members_;
};

/// What it did in one step changes nothing of what it does in another: a memory of sizes alone.
/// Once it has seen as many contacts and bodies as it will, it allocates nothing.
class Responder {
 public:
  /// Applies impulses to `states`, as respond() or respond_together() and the rules say; a
  /// restitution in [0, 1] for each contact. The result is valid until the next call.
  const ResponseResult& respond(const std::vector<Contact>& contacts,
                                const std::vector<double>& restitutions, const ResponseRules& rules,
                                const std::vector<BodyModel>& models,
                                std::vector<BodyState>& states);

 private:
  /// False when they were interrupted.
  bool respond_in_turn(const std::vector<double>& restitutions, const ResponseRules& rules,
                       std::vector<BodyState>& states);
  bool respond_together(const std::vector<Contact>& contacts,
                        const std::vector<double>& restitutions, const ResponseRules& rules,
                        std::vector<BodyState>& states);

  ContactBodies bodies_;
  Islands islands_;
  ImpulsesInTurn<ContactBodies> in_turn_;
  ImpulsesTogether together_;
  std::vector<std::size_t> all_;
  ResponseResult result_;
};

}  // namespace impetus::inline dynamics
