// SPDX-License-Identifier: MIT
#include "engine/collision/contact_patches.hpp"

#include <algorithm>
#include <cmath>

#include "engine/numerics/at.hpp"

namespace impetus::inline collision {
namespace {

std::uint64_t both_groups(std::int32_t a, std::int32_t b) {
  return std::uint64_t{static_cast<std::uint32_t>(a)} << 32 | static_cast<std::uint32_t>(b);
}

}  // namespace

/// Of an even row of points with the patch's variance along `direction` (unit).
double ContactPatches::Patch::half_length_m(const Vector3& direction) const {
  return std::sqrt(std::max(0.0, 3.0 * direction.dot(scatter_m2 * direction) / count));
}

bool ContactPatches::Patch::is_near(const Patch& other) const {
  const Vector3 between = mean_point() - other.mean_point();
  const double apart_m = between.norm();
  const double neighbours_m = 2.0 * std::max(node_m, other.node_m);
  if (apart_m <= neighbours_m) {
    return true;
  }
  const Vector3 along = between / apart_m;
  return apart_m <= half_length_m(along) + other.half_length_m(along) + neighbours_m;
}

bool ContactPatches::Patch::faces_as(const Patch& other) const {
  return normals.dot(other.normals) >= kOneSurfaceCosine * normals.norm() * other.normals.norm();
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

void ContactPatches::Patch::join_one(const NodeContact& contact, double weight_of_it) {
  const TouchPoint& touch = contact.touch;
  const Vector3 between = mean_point() - touch.point;
  scatter_m2 += count / (count + 1.0) * (between * between.transpose());
  count += 1.0;
  normals += touch.normal;
  points += touch.point;
  weight += weight_of_it;
  weighted_normals += weight_of_it * touch.normal;
  weighted_points += weight_of_it * touch.point;
  depth_m = std::max(depth_m, std::max(0.0, touch.depth_m));
  node_m = std::max(node_m, contact.node_m);
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

ContactPatches::Patch ContactPatches::patch_of(const NodeContact& contact, double weight) {
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
  return one;
}

void ContactPatches::clear() {
  patches_.clear();
  next_.clear();
  if (++round_ == 0) {
    by_groups_.clear();
    round_ = 1;
  }
}

/// Of these groups, or where they would be entered.
ContactPatches::OfGroups& ContactPatches::entry_of(std::uint64_t groups) {
  const std::size_t mask = by_groups_.size() - 1;
  std::size_t slot = static_cast<std::size_t>((groups * 0x9e3779b97f4a7c15) >> 32) & mask;
  while (by_groups_[slot].round == round_ && by_groups_[slot].groups != groups) {
    slot = (slot + 1) & mask;
  }
  return by_groups_[slot];
}

ContactPatches::Patch* ContactPatches::patch_for(const NodeContact& contact,
                                                 const OfGroups& of_groups) {
  Patch* best = nullptr;
  double longest = kOneSurfaceCosine;
  const bool of_surfaces = contact.group_a != kNoGroup && contact.group_b != kNoGroup;
  for (std::int32_t i = of_groups.first; i >= 0; i = next_[at(i)]) {
    Patch& patch = patches_[at(i)];
    if (of_surfaces || patch_of(contact, /*weight=*/1.0).is_near(patch)) {
      const double length = (patch.normals + contact.touch.normal).norm() / (patch.count + 1.0);
      if (length >= longest) {
        best = &patch;
        longest = length;
      }
    }
  }
  return best;
}

void ContactPatches::begin_patch(const NodeContact& contact, double weight, OfGroups& of_groups) {
  const auto place = static_cast<std::int32_t>(patches_.size());
  const std::uint64_t groups = both_groups(contact.group_a, contact.group_b);
  if (of_groups.round == round_) {
    next_[at(of_groups.last)] = place;
    of_groups.last = place;
  } else {
    of_groups = {groups, round_, place, place};
  }
  patches_.push_back(patch_of(contact, weight));
  next_.push_back(-1);
}

void ContactPatches::make_room() {
  constexpr std::size_t kFewest = 64;
  by_groups_.assign(std::max(kFewest, 2 * by_groups_.size()), OfGroups{});
  for (std::size_t i = 0; i < patches_.size(); ++i) {
    const auto place = static_cast<std::int32_t>(i);
    const std::uint64_t groups = both_groups(patches_[i].group_a, patches_[i].group_b);
    OfGroups& of_groups = entry_of(groups);
    if (of_groups.round != round_) {
      of_groups = {groups, round_, place, place};
    }
    of_groups.last = place;
  }
}

void ContactPatches::add(const NodeContact& contact, double weight) {
  if (2 * patches_.size() >= by_groups_.size()) {
    make_room();
  }
  OfGroups& of_groups = entry_of(both_groups(contact.group_a, contact.group_b));
  Patch* patch = of_groups.round == round_ ? patch_for(contact, of_groups) : nullptr;
  if (patch != nullptr) {
    patch->join_one(contact, weight);
  } else {
    begin_patch(contact, weight, of_groups);
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
