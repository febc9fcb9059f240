// SPDX-License-Identifier: MIT
#include "engine/collision/contact_model.hpp"

#include <algorithm>
#include <memory>

#include "engine/collision/torque_span.hpp"

namespace impetus {
namespace {

/// Reduces the contacts of one pair, or of a body and a wall.
class Reducing {
 public:
  Reducing(BodyPair bodies, const ContactModel& model, const Vector3& fallback,
           std::vector<Contact>* watched)
      : bodies_(bodies),
        most_(model.most_per_pair),
        sums_(reduction_of(model).begin(fallback)),
        watched_(watched) {}

  void add(const NodeContact& contact) {
    sums_->add(contact);
    if (watched_ != nullptr) {
      watched_->push_back({bodies_, contact.touch});
    }
  }

  void add_reduced_to(std::vector<Contact>& contacts, double size_m) const {
    for (const TouchPoint& touch : spanning_most_torque(sums_->reduced(), most_, size_m)) {
      contacts.push_back({bodies_, touch});
    }
  }

 private:
  BodyPair bodies_;
  int most_;
  std::unique_ptr<ContactSums> sums_;
  std::vector<Contact>* watched_;
};

Vector3 outward_in_world(const PlacedTree& tree, const NodeSurface& surface) {
  return tree.pose().orientation * surface.density_normal.cast<double>();
}

void weigh(NodeContact& contact, const NodePair& nodes, const MovingTree& a, const MovingTree& b) {
  const TouchPoint& touch = contact.touch;
  const NodeSurface& of_a = a.tree.tree().surface(nodes.a);
  const NodeSurface& of_b = b.tree.tree().surface(nodes.b);
  const Volume node_a = a.tree.world_volume(nodes.a);
  const Volume node_b = b.tree.world_volume(nodes.b);
  const Vector3 moving = a.motion.velocity_at(touch.point) - b.motion.velocity_at(touch.point);
  const double reach_m =
      0.5 * (width_along(node_a, touch.normal) + width_along(node_b, touch.normal));
  contact.approach_m_s = -touch.normal.dot(moving);
  contact.since_entry_s =
      time_since_entry_s(reach_m, touch.depth_m, contact.approach_m_s, moving.norm());
  contact.node_m = std::min(bounding_sphere(node_a).radius_m, bounding_sphere(node_b).radius_m);
  contact.interpenetration = interpenetration(node_a, node_b, touch);
  contact.occupancy_a = static_cast<double>(of_a.occupancy);
  contact.occupancy_b = static_cast<double>(of_b.occupancy);
  contact.group_a = of_a.group;
  contact.group_b = of_b.group;
  contact.outward_a = outward_in_world(a.tree, of_a);
  contact.outward_b = outward_in_world(b.tree, of_b);
}

/// A wall is solid, and faces inwards everywhere.
void weigh_at_wall(NodeContact& contact, std::int32_t node, const MovingTree& a) {
  const TouchPoint& touch = contact.touch;
  const NodeSurface& surface = a.tree.tree().surface(node);
  contact.approach_m_s = -touch.normal.dot(a.motion.velocity_at(touch.point));
  if (contact.approach_m_s > 0.0) {
    contact.since_entry_s = touch.depth_m / contact.approach_m_s;
  }
  const Volume volume = a.tree.world_volume(node);
  contact.node_m = bounding_sphere(volume).radius_m;
  contact.interpenetration = wall_interpenetration(volume, touch);
  contact.occupancy_a = static_cast<double>(surface.occupancy);
  contact.group_a = surface.group;
  contact.outward_a = -touch.normal;
  contact.outward_b = touch.normal;
}

}  // namespace

Vector3 NormalFallbacks::first_usable() const {
  for (const Vector3* direction : {&last_normal, &between_centres_of_mass, &approach}) {
    const double length = direction->norm();
    if (length > 0.0) {
      return *direction / length;
    }
  }
  return Vector3::UnitX();
}

std::vector<Contact> pair_contacts(BodyPair bodies, const PairRefinement& pair, const MovingTree& a,
                                   const MovingTree& b, const NormalFallbacks& fallbacks,
                                   const ContactModel& model, std::vector<Contact>* watched) {
  std::vector<Contact> contacts;
  if (pair.overlapping().empty()) {
    return contacts;
  }
  const Vector3 fallback = fallbacks.first_usable();
  const bool weighs = reduction_of(model).weighs();
  Reducing reducing(bodies, model, fallback, watched);
  for (const NodePair& nodes : pair.overlapping()) {
    NodeContact contact;
    contact.touch = touch_of_nodes(a.tree, nodes.a, b.tree, nodes.b, fallback);
    if (weighs) {
      weigh(contact, nodes, a, b);
    }
    reducing.add(contact);
  }
  reducing.add_reduced_to(
      contacts, std::min(a.tree.tree().bounding_radius_m(), b.tree.tree().bounding_radius_m()));
  return contacts;
}

std::vector<Contact> wall_contacts(std::int32_t body, const PairRefinement& pair,
                                   const MovingTree& a, const Enclosure& walls,
                                   const ContactModel& model, std::vector<Contact>* watched) {
  std::vector<Contact> contacts;
  const bool weighs = reduction_of(model).weighs();
  for (int wall = 0; wall < kWallCount; ++wall) {
    const Vector3 normal = inward_normal(walls, wall);
    const std::size_t of_walls_before = contacts.size();
    Reducing reducing({body, wall_index(wall)}, model, normal, watched);
    for (const NodePair& nodes : pair.overlapping()) {
      NodeContact contact;
      contact.touch = touch_of_wall(a.tree, nodes.a, walls, wall);
      if (contact.touch.depth_m >= 0.0) {
        if (weighs) {
          weigh_at_wall(contact, nodes.a, a);
        }
        reducing.add(contact);
      }
    }
    reducing.add_reduced_to(contacts, a.tree.tree().bounding_radius_m());
    for (std::size_t i = of_walls_before; i < contacts.size(); ++i) {
      contacts[i].touch.normal = normal;  // whatever a mean of equals rounds to
    }
  }
  return contacts;
}

}  // namespace impetus
