// Groups whose normals come from the density gradients of the two nodes.
//
// The outward normal of b points to a, that of a to b, so the pair's is (n_b − n_a) made unit.
// (Dingliana 2002, sec. 4.2.4, eq. 4.10, corrected)
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "engine/collision/contact_patches.hpp"
#include "engine/collision/contact_reduction.hpp"

namespace impetus::inline collision {

/// Outward normals less than 90° apart, whose difference is shorter than this, are not of surfaces
/// that face each other: the geometric normal stands.
inline constexpr double kLeastOpposed = 1.4142135623730951;

/// The normal, unit and from b to a, that the densities of the two nodes give.
inline Vector3 density_contact_normal(const NodeContact& contact) {
  const Vector3 difference = contact.outward_b - contact.outward_a;
  const double length = difference.norm();
  return length >= kLeastOpposed ? Vector3(difference / length) : contact.touch.normal;
}

class DensityContacts final : public ContactSums {
 public:
  void begin(const Vector3& /*fallback*/) override { patches_.clear(); }

  void add(const NodeContact& contact) override {
    NodeContact faced = contact;
    faced.touch.normal = density_contact_normal(contact);
    patches_.add(faced, /*weight=*/1.0);
  }
  void reduce_to(std::vector<TouchPoint>& contacts) const override {
    patches_.add_contacts_to(contacts);
  }

 private:
  ContactPatches patches_;
};

}  // namespace impetus::inline collision
