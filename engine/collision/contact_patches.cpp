// SPDX-License-Identifier: MIT
#include "engine/collision/contact_patches.hpp"

#include <algorithm>

namespace impetus {

ContactPatches::Patch& ContactPatches::patch_for(std::int32_t group_a, std::int32_t group_b,
                                                 const Vector3& normal) {
  Patch* best = nullptr;
  double longest = kOneSurfaceCosine;
  for (Patch& patch : patches_) {
    if (patch.group_a != group_a || patch.group_b != group_b) {
      continue;
    }
    const double length = (patch.normals + normal).norm() / (patch.count + 1.0);
    if (length > longest) {
      best = &patch;
      longest = length;
    }
  }
  if (best != nullptr) {
    return *best;
  }
  Patch begun;
  begun.group_a = group_a;
  begun.group_b = group_b;
  patches_.push_back(begun);
  return patches_.back();
}

void ContactPatches::add(std::int32_t group_a, std::int32_t group_b, const TouchPoint& touch,
                         double weight) {
  Patch& patch = patch_for(group_a, group_b, touch.normal);
  patch.count += 1.0;
  patch.normals += touch.normal;
  patch.points += touch.point;
  patch.weight += weight;
  patch.weighted_normals += weight * touch.normal;
  patch.weighted_points += weight * touch.point;
  patch.depth_m = std::max(patch.depth_m, touch.depth_m);
}

TouchPoint ContactPatches::contact_of(const Patch& patch) {
  const double weighted_length = patch.weighted_normals.norm();
  TouchPoint contact;
  // The plain mean of a patch's normals is never short, so this direction always exists.
  contact.normal = weighted_length > 0.0 ? Vector3(patch.weighted_normals / weighted_length)
                                         : Vector3(patch.normals / patch.normals.norm());
  contact.point = patch.weight > 0.0 ? Vector3(patch.weighted_points / patch.weight)
                                     : Vector3(patch.points / patch.count);
  contact.depth_m = patch.depth_m;
  return contact;
}

std::vector<TouchPoint> ContactPatches::contacts() const {
  std::vector<TouchPoint> contacts;
  contacts.reserve(patches_.size());
  for (const Patch& patch : patches_) {
    contacts.push_back(contact_of(patch));
  }
  return contacts;
}

}  // namespace impetus
