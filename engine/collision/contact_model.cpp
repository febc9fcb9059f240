// SPDX-License-Identifier: MIT
#include "engine/collision/contact_model.hpp"

#include <algorithm>
#include <bit>

namespace impetus::inline collision {
namespace {

Vector3 outward_in_world(const PlacedTree& tree, const NodeSurface& surface) {
  return tree.pose().orientation * surface.density_normal.cast<double>();
}

/// Two nodes of any kind.
struct TwoVolumes {
  Volume a;
  Volume b;

  [[nodiscard]] double reach_m(const Vector3& normal) const {
    return 0.5 * (width_along(a, normal) + width_along(b, normal));
  }
  [[nodiscard]] double smaller_m() const {
    return std::min(bounding_sphere(a).radius_m, bounding_sphere(b).radius_m);
  }
  [[nodiscard]] double depth_share(const TouchPoint& touch) const {
    return interpenetration(a, b, touch);
  }
};

/// Two that are spheres, by their radii.
struct TwoSpheres {
  double radius_a_m;
  double radius_b_m;

  [[nodiscard]] double reach_m(const Vector3& /*normal*/) const { return radius_a_m + radius_b_m; }
  [[nodiscard]] double smaller_m() const { return std::min(radius_a_m, radius_b_m); }
  [[nodiscard]] double depth_share(const TouchPoint& touch) const {
    return interpenetration(Sphere{{}, radius_a_m}, Sphere{{}, radius_b_m}, touch);
  }
};

/// Finds what is asked for of a contact of two nodes.
template <typename TwoNodes>
void weigh(NodeContact& contact, unsigned terms, const NodePair& nodes, const TwoNodes& two,
           const MovingTree& a, const MovingTree& b) {
  const TouchPoint& touch = contact.touch;
  const NodeSurface& of_a = a.tree.tree().surface(nodes.a);
  const NodeSurface& of_b = b.tree.tree().surface(nodes.b);
  if ((terms & kEntryTerm) != 0) {
    const Vector3 moving = a.motion.velocity_at(touch.point) - b.motion.velocity_at(touch.point);
    contact.approach_m_s = -touch.normal.dot(moving);
    contact.since_entry_s = time_since_entry_s(two.reach_m(touch.normal), touch.depth_m,
                                               contact.approach_m_s, moving.norm());
  }
  if ((terms & kGroupTerm) != 0) {
    contact.node_m = two.smaller_m();
    contact.group_a = of_a.group;
    contact.group_b = of_b.group;
  }
  if ((terms & kChanceTerm) != 0) {
    contact.interpenetration = two.depth_share(touch);
    contact.occupancy_a = static_cast<double>(of_a.occupancy);
    contact.occupancy_b = static_cast<double>(of_b.occupancy);
  }
  if ((terms & kOutwardTerm) != 0) {
    contact.outward_a = outward_in_world(a.tree, of_a);
    contact.outward_b = outward_in_world(b.tree, of_b);
  }
}

/// The same of a node and a wall, which is solid and faces inwards everywhere.
void weigh_at_wall(NodeContact& contact, unsigned terms, std::int32_t node, const MovingTree& a) {
  const TouchPoint& touch = contact.touch;
  const NodeSurface& surface = a.tree.tree().surface(node);
  const Volume volume = a.tree.world_volume(node);
  if ((terms & kEntryTerm) != 0) {
    contact.approach_m_s = -touch.normal.dot(a.motion.velocity_at(touch.point));
    contact.since_entry_s = contact.approach_m_s > 0.0 ? touch.depth_m / contact.approach_m_s : 0.0;
  }
  if ((terms & kGroupTerm) != 0) {
    contact.node_m = bounding_sphere(volume).radius_m;
    contact.group_a = surface.group;
  }
  if ((terms & kChanceTerm) != 0) {
    contact.interpenetration = wall_interpenetration(volume, touch);
    contact.occupancy_a = static_cast<double>(surface.occupancy);
  }
  if ((terms & kOutwardTerm) != 0) {
    contact.outward_a = -touch.normal;
    contact.outward_b = touch.normal;
  }
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

void ContactModelling::begin(BodyPair bodies, const ContactModel& model, const Vector3& fallback,
                             std::vector<Contact>* watched) {
  if (!sums_ || reduction_ != model.reduction) {
    reduction_ = model.reduction;
    sums_ = reduction_of(model).make_sums();
  }
  sums_->begin(fallback);
  bodies_ = bodies;
  watched_ = watched;
}

void ContactModelling::add(const NodeContact& contact) {
  sums_->add(contact);
  if (watched_ != nullptr) {
    watched_->push_back({bodies_, contact.touch});
  }
}

void ContactModelling::add_touches(std::span<const TouchPoint> touches) {
  sums_->add_touches(touches);
  if (watched_ != nullptr) {
    for (const TouchPoint& touch : touches) {
      watched_->push_back({bodies_, touch});
    }
  }
}

void ContactModelling::add_contacts_of_spheres(const PairRefinement& pair, const MovingTree& a,
                                               const MovingTree& b, const Vector3& fallback,
                                               unsigned terms) {
  SpherePairs spheres{};
  TouchPoint touches[kLanes];
  NodePair nodes[kLanes];
  NodeContact contact;
  int lanes = 0;
  const auto add_lanes = [&] {
    touches_of_pairs(spheres, fallback, touches);
    if (terms == 0) {
      add_touches({touches, static_cast<std::size_t>(lanes)});
    }
    for (int lane = 0; terms != 0 && lane < lanes; ++lane) {
      contact.touch = touches[lane];
      weigh(contact, terms, nodes[lane], TwoSpheres{spheres.a[3][lane], spheres.b[3][lane]}, a, b);
      add(contact);
    }
    lanes = 0;
  };
  for (const NodeBlock& block : pair.overlapping().blocks()) {
    const SphereLanes of_a = a.tree.world_lanes(block.first.a);
    const SphereLanes of_b = b.tree.world_lanes(block.first.b);
    for (std::uint64_t bits = block.bits; bits != 0; bits &= bits - 1) {
      const int bit = std::countr_zero(bits);
      const int row = bit / kLanes;
      const int column = bit % kLanes;
      spheres.put(lanes, of_a, row, of_b, column);
      nodes[lanes] = {block.first.a + row, block.first.b + column};
      if (++lanes == kLanes) {
        add_lanes();
      }
    }
  }
  if (lanes > 0) {
    add_lanes();
  }
}

void ContactModelling::add_reduced_to(std::vector<Contact>& contacts, int most, double size_m) {
  reduced_.clear();
  sums_->reduce_to(reduced_);
  torque_span_.keep_widest(reduced_, most, size_m);
  for (const TouchPoint& touch : reduced_) {
    contacts.push_back({bodies_, touch});
  }
}

void ContactModelling::add_pair_contacts(BodyPair bodies, const PairRefinement& pair,
                                         const MovingTree& a, const MovingTree& b,
                                         const NormalFallbacks& fallbacks,
                                         const ContactModel& model, std::vector<Contact>& contacts,
                                         std::vector<Contact>* watched) {
  if (pair.overlapping().empty()) {
    return;
  }
  const Vector3 fallback = fallbacks.first_usable();
  const unsigned terms = reduction_of(model).terms();
  begin(bodies, model, fallback, watched);
  if (pair.of_spheres()) {
    add_contacts_of_spheres(pair, a, b, fallback, terms);
  } else {
    for (const NodePair& nodes : pair.overlapping()) {
      NodeContact contact;
      contact.touch = touch_of_nodes(a.tree, nodes.a, b.tree, nodes.b, fallback);
      if (terms != 0) {
        const TwoVolumes two{a.tree.world_volume(nodes.a), b.tree.world_volume(nodes.b)};
        weigh(contact, terms, nodes, two, a, b);
      }
      add(contact);
    }
  }
  add_reduced_to(contacts, model.most_per_pair,
                 std::min(a.tree.tree().bounding_radius_m(), b.tree.tree().bounding_radius_m()));
}

void ContactModelling::add_wall_contacts(std::int32_t body, const PairRefinement& pair,
                                         const MovingTree& a, const Enclosure& walls,
                                         const ContactModel& model, std::vector<Contact>& contacts,
                                         std::vector<Contact>* watched) {
  const unsigned terms = reduction_of(model).terms();
  const Sphere all{a.tree.pose().position, a.tree.reach_m()};
  for (int wall = 0; wall < kWallCount; ++wall) {
    if (reach_beyond(walls, wall, all) < 0.0) {
      continue;  // none of its nodes gets there
    }
    const Vector3 normal = inward_normal(walls, wall);
    const std::size_t of_walls_before = contacts.size();
    begin({body, wall_index(wall)}, model, normal, watched);
    for (const NodePair& nodes : pair.overlapping()) {
      NodeContact contact;
      contact.touch = touch_of_wall(a.tree, nodes.a, walls, wall);
      if (contact.touch.depth_m >= 0.0) {
        if (terms != 0) {
          weigh_at_wall(contact, terms, nodes.a, a);
        }
        add(contact);
      }
    }
    add_reduced_to(contacts, model.most_per_pair, a.tree.tree().bounding_radius_m());
    for (std::size_t i = of_walls_before; i < contacts.size(); ++i) {
      contacts[i].touch.normal = normal;  // whatever a mean of equals rounds to
    }
  }
}

}  // namespace impetus::inline collision
