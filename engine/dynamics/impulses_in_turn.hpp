// Impulses one after the other, without looking twice at a contact whose bodies nobody touched.
//
//   awake: contacts to be looked at        asleep: found not approaching, or pushed, and
//          ^                                       nobody pushed their bodies since
//          '---- a push wakes every contact of the bodies it moved
//
// What a contact does depends on the momenta of its two bodies alone, so one that sleeps would be
// found as it was: passes over the awake, in the order of the contacts, give the bits of passes
// over all. A pass over n contacts of which k are awake costs n / 64 + k.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/dynamics/contact_bodies.hpp"
#include "engine/dynamics/impulse.hpp"

namespace impetus {

/// Keeps its arrays from one step to the next.
class ImpulsesInTurn {
 public:
  /// Prepares for the contacts of `bodies`, which must live while this responds.
  void look_at(const ContactBodies& bodies);

  /// As respond_in_turn() (impulse.hpp): `members` rise, and no other contact touches a body of
  /// theirs that moves. `bodies` are those looked at.
  void respond(std::span<const std::size_t> members, const std::vector<double>& restitutions,
               const ResponseRules& rules, ContactBodies& bodies, std::vector<BodyState>& states,
               std::vector<double>& impulse_Ns);

 private:
  static constexpr double kUnknown = -1.0;

  [[nodiscard]] std::size_t next_awake(std::size_t from, std::size_t end) const;
  void wake(std::size_t contact) { awake_[contact / 64] |= std::uint64_t{1} << (contact % 64); }
  void wake_contacts_of(std::int32_t place, const ContactBodies& bodies);
  void sleep(std::size_t contact) { awake_[contact / 64] &= ~(std::uint64_t{1} << (contact % 64)); }
  double push_if_approaching(std::size_t contact, double restitution, double resting_m_s,
                             ContactBodies& bodies, std::vector<BodyState>& states);

  std::vector<std::uint64_t> awake_;          ///< a bit for each contact
  std::vector<double> gives_;                 ///< of each contact, once it was needed
  std::vector<std::uint32_t> first_of_body_;  ///< where each body's contacts begin
  std::vector<std::uint32_t> contacts_of_body_;
};

}  // namespace impetus
