// Pre-processed grouping: one mean for each pair of nearly plane pieces of surface that meet.
// (Dingliana 2002, sec. 4.2.3)
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "engine/collision/contact_patches.hpp"
#include "engine/collision/contact_reduction.hpp"

namespace impetus {

class GroupedContacts final : public ContactSums {
 public:
  explicit GroupedContacts(const Vector3& /*fallback*/) {}

  void add(const NodeContact& contact) override { patches_.add(contact, /*weight=*/1.0); }
  [[nodiscard]] std::vector<TouchPoint> reduced() const override { return patches_.contacts(); }

 private:
  ContactPatches patches_;
};

}  // namespace impetus
