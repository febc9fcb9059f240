// SPDX-License-Identifier: MIT
#include "engine/collision/contact_patches.hpp"

#include <algorithm>
#include <cmath>

namespace impetus::inline collision {

/// Of an even row of points with the patch's variance along `direction` (unit).
double ContactPatches::Patch::half_length_m(const Vector3& direction) const {
  return std::sqrt(std::max(0.0, 3.0 * direction.dot(scatter_m2 * direction) / count));
}

bool ContactPatches::Patch::is_near(const Patch& other) const {
  const Vector3 between = mean_point() - other.mean_point();
  const double apart_m = between.norm();
  const Vector3 along = apart_m > 0.0 ? Vector3(between / apart_m) : Vector3::Zero();
  const double neighbours_m = 2.0 * std::max(node_m, other.node_m);
  return apart_m <= half_length_m(along) + other.half_length_m(along) + neighbours_m;
}

bool ContactPatches::Patch::faces_as(const Patch& other) const {
  return normals.dot(other.normals) >= kOneSurfaceCosine * normals.norm() * other.normals.norm();
}

bool ContactPatches::Patch::may_be_of(const Patch& patch) const {
  return group_a == patch.group_a && group_b == patch.group_b &&
         ((group_a != kNoGroup && group_b != kNoGroup) || is_near(patch));
}

void ContactPatches::Patch::join(const Patch& other) {
  const Vector3 between = mean_point() - other.mean_point();
  scatter_m2 += other.scatter_m2 +
                count * other.count / (count + other.count) * (between * between.transpose());
  count += other.count;
  normals += other.normals;
  points += other.points;
  weight += other.weight;
  weighted_normals += other.weighted_normals;
  weighted_points += other.weighted_points;
  depth_m = std::max(depth_m, other.depth_m);
  node_m = std::max(node_m, other.node_m);
}

TouchPoint ContactPatches::Patch::contact() const {
  const double weighted_length = weighted_normals.norm();
  TouchPoint touch;
  // The plain mean of a patch's normals is never short, so one of the two directions exists.
  touch.normal = weighted_length > 0.0 ? Vector3(weighted_normals / weighted_length)
                                       : Vector3(normals / normals.norm());
  touch.point = weight > 0.0 ? Vector3(weighted_points / weight) : mean_point();
  touch.depth_m = depth_m;
  return touch;
}

ContactPatches::Patch* ContactPatches::patch_for(const Patch& contact) {
  Patch* best = nullptr;
  double longest = kOneSurfaceCosine;
  for (Patch& patch : patches_) {
    if (contact.may_be_of(patch)) {
      const double length = (patch.normals + contact.normals).norm() / (patch.count + 1.0);
      if (length >= longest) {
        best = &patch;
        longest = length;
      }
    }
  }
  return best;
}

void ContactPatches::add(const NodeContact& contact, double weight) {
  const TouchPoint& touch = contact.touch;
  Patch one;
  one.group_a = contact.group_a;
  one.group_b = contact.group_b;
  one.count = 1.0;
  one.normals = touch.normal;
  one.points = touch.point;
  one.weight = weight;
  one.weighted_normals = weight * touch.normal;
  one.weighted_points = weight * touch.point;
  one.depth_m = std::max(0.0, touch.depth_m);
  one.node_m = contact.node_m;
  if (Patch* patch = patch_for(one)) {
    patch->join(one);
  } else {
    patches_.push_back(one);
  }
}

void ContactPatches::add_contacts_to(std::vector<TouchPoint>& contacts) const {
  whole_.clear();
  for (const Patch& patch : patches_) {
    const auto before = std::find_if(whole_.begin(), whole_.end(), [&](const Patch& other) {
      return patch.faces_as(other) && patch.is_near(other);
    });
    if (before == whole_.end()) {
      whole_.push_back(patch);
    } else {
      before->join(patch);
    }
  }
  for (const Patch& patch : whole_) {
    contacts.push_back(patch.contact());
  }
}

}  // namespace impetus::inline collision
