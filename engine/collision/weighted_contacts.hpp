// Groups weighted by the probability that the solids meet, P = κ ρ_a ρ_b.
// (Dingliana 2002, sec. 4.2.5, eq. 4.6, 4.11 and 4.12, corrected)
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "engine/collision/contact_patches.hpp"
#include "engine/collision/contact_reduction.hpp"

namespace impetus::inline collision {

class WeightedContacts final : public ContactSums {
 public:
  void begin(const Vector3& /*fallback*/) override { patches_.clear(); }

  void add(const NodeContact& contact) override {
    patches_.add(contact, collision_probability(contact));
  }
  void reduce_to(std::vector<TouchPoint>& contacts) const override {
    patches_.add_contacts_to(contacts);
  }

 private:
  ContactPatches patches_;
};

}  // namespace impetus::inline collision
