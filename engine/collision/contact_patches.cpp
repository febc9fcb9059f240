// SPDX-License-Identifier: MIT
#include "engine/collision/contact_patches.hpp"

#include <algorithm>
#include <cmath>

namespace impetus {

double ContactPatches::Patch::spread_m() const { return std::sqrt(scatter_m2 / count); }

bool ContactPatches::Patch::continues(const Patch& other) const {
  const double apart_m = (mean_point() - other.mean_point()).norm();
  const double neighbours_m = 2.0 * std::max(node_m, other.node_m);
  return normals.dot(other.normals) >= kOneSurfaceCosine * normals.norm() * other.normals.norm() &&
         apart_m <= spread_m() + other.spread_m() + neighbours_m;
}

void ContactPatches::Patch::join(const Patch& other) {
  const double apart_m2 = (mean_point() - other.mean_point()).squaredNorm();
  scatter_m2 += other.scatter_m2 + apart_m2 * count * other.count / (count + other.count);
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
    if (patch.group_a == contact.group_a && patch.group_b == contact.group_b) {
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

std::vector<TouchPoint> ContactPatches::contacts() const {
  std::vector<Patch> whole;
  for (const Patch& patch : patches_) {
    const auto before = std::find_if(whole.begin(), whole.end(),
                                     [&](const Patch& other) { return patch.continues(other); });
    if (before == whole.end()) {
      whole.push_back(patch);
    } else {
      before->join(patch);
    }
  }
  std::vector<TouchPoint> contacts;
  contacts.reserve(whole.size());
  for (const Patch& patch : whole) {
    contacts.push_back(patch.contact());
  }
  return contacts;
}

}  // namespace impetus
