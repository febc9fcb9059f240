// Pre-processed grouping: one mean for each pair of nearly plane pieces of surface that meet.
// (Dingliana 2002, sec. 4.2.3)
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "engine/collision/contact_patches.hpp"
#include "engine/collision/contact_reduction.hpp"

namespace impetus::inline collision {

class GroupedContacts final : public ContactSums {
 public:
  void begin(const Vector3& /*fallback*/) override { patches_.clear(); }

  void add(const NodeContact& contact) override { patches_.add(contact, /*weight=*/1.0); }
  void reduce_to(std::vector<TouchPoint>& contacts) const override {
    patches_.add_contacts_to(contacts);
  }

 private:
  ContactPatches patches_;
};

}  // namespace impetus::inline collision
