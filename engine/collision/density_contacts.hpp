// Groups whose normals come from the density gradients of the two nodes.
//
// The outward normal of b points to a, that of a to b, so the pair's is (n_b − n_a) made unit.
// (Dingliana 2002, sec. 4.2.4, eq. 4.10, corrected)
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "engine/collision/contact_patches.hpp"
#include "engine/collision/contact_reduction.hpp"

namespace impetus {

/// Outward normals whose difference is shorter than this, 11° from the same way, do not say which
/// body is on which side: the geometric normal stands.
inline constexpr double kLeastOpposed = 0.2;

/// The normal, unit and from b to a, that the densities of the two nodes give.
inline Vector3 density_contact_normal(const NodeContact& contact) {
  const Vector3 difference = contact.outward_b - contact.outward_a;
  const double length = difference.norm();
  return length >= kLeastOpposed ? Vector3(difference / length) : contact.touch.normal;
}

class DensityContacts final : public ContactSums {
 public:
  explicit DensityContacts(const Vector3& /*fallback*/) {}

  void add(const NodeContact& contact) override {
    TouchPoint touch = contact.touch;
    touch.normal = density_contact_normal(contact);
    patches_.add(contact.group_a, contact.group_b, touch, /*weight=*/1.0);
  }
  [[nodiscard]] std::vector<TouchPoint> reduced() const override { return patches_.contacts(); }

 private:
  ContactPatches patches_;
};

}  // namespace impetus
