// Groups weighted by the probability that the solids meet, P = κ ρ_a ρ_b.
// (Dingliana 2002, sec. 4.2.5, eq. 4.6, 4.11 and 4.12, corrected)
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "engine/collision/contact_patches.hpp"
#include "engine/collision/contact_reduction.hpp"

namespace impetus {

class WeightedContacts final : public ContactSums {
 public:
  explicit WeightedContacts(const Vector3& /*fallback*/) {}

  void add(const NodeContact& contact) override {
    patches_.add(contact, collision_probability(contact));
  }
  [[nodiscard]] std::vector<TouchPoint> reduced() const override { return patches_.contacts(); }

 private:
  ContactPatches patches_;
};

}  // namespace impetus
