// SPDX-License-Identifier: MIT
#include "engine/collision/contact_model.hpp"

#include <algorithm>
#include <cassert>

namespace impetus {

Vector3 NormalFallbacks::first_usable() const {
  for (const Vector3* direction : {&between_centres_of_mass, &approach}) {
    const double length = direction->norm();
    if (length > 0.0) {
      return *direction / length;
    }
  }
  return Vector3::UnitX();
}

Contact average_contact(BodyPair bodies, const PairRefinement& pair, PlacedTree& a, PlacedTree& b,
                        const NormalFallbacks& fallbacks) {
  const std::vector<NodePair>& nodes = pair.overlapping();
  assert(!nodes.empty());
  const Vector3 fallback = fallbacks.first_usable();
  Vector3 points = Vector3::Zero();
  Vector3 normals = Vector3::Zero();
  double depth_m = 0.0;
  for (const NodePair& node : nodes) {
    const TouchPoint at = touch_of_nodes(a, node.a, b, node.b, fallback);
    points += at.point;
    normals += at.normal;
    depth_m = std::max(depth_m, at.depth_m);
  }
  const double length = normals.norm();
  Contact contact;
  contact.bodies = bodies;
  contact.touch.point = points / static_cast<double>(nodes.size());
  contact.touch.normal = length > 0.0 ? Vector3(normals / length) : fallback;
  contact.touch.depth_m = depth_m;
  return contact;
}

std::vector<Contact> wall_contacts(std::int32_t body, const PairRefinement& pair, PlacedTree& tree,
                                   const Enclosure& walls) {
  std::vector<Contact> contacts;
  for (int wall = 0; wall < kWallCount; ++wall) {
    Contact contact;
    contact.bodies = {body, wall_index(wall)};
    contact.touch.normal = inward_normal(walls, wall);
    int count = 0;
    for (const NodePair& node : pair.overlapping()) {
      const TouchPoint at = touch_of_wall(tree, node.a, walls, wall);
      if (at.depth_m >= 0.0) {
        contact.touch.point += at.point;
        contact.touch.depth_m = std::max(contact.touch.depth_m, at.depth_m);
        ++count;
      }
    }
    if (count > 0) {
      contact.touch.point /= count;
      contacts.push_back(contact);
    }
  }
  return contacts;
}

}  // namespace impetus
