// From overlapping nodes to the contacts that the response gets.
//
//   overlapping nodes --touch, and what weighs it--> reduction --cap--> contacts
//
// (Dingliana 2002, ch. 4)
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "engine/collision/contact_reduction.hpp"
#include "engine/collision/pair_refinement.hpp"
#include "engine/collision/torque_span.hpp"
#include "engine/scheduling/priority.hpp"

namespace impetus::inline collision {

/// One contact between two bodies, or of a body and a wall: `normal` unit, from b towards a, in
/// world.
struct Contact {
  BodyPair bodies;
  TouchPoint touch;
};

/// Directions to fall back on when the geometry leaves the normal open (coincident centres, opposed
/// normals), all from b towards a: the pair's normal in the step before, the line of the centres of
/// mass, the relative velocity. Zero vectors are passed over, and the x axis is the last resort.
/// (eq. 3.7, corrected)
struct NormalFallbacks {
  Vector3 between_centres_of_mass{Vector3::Zero()};
  Vector3 approach{Vector3::Zero()};     ///< −(v_a − v_b)
  Vector3 last_normal{Vector3::Zero()};  ///< of the step before, before the others

  [[nodiscard]] Vector3 first_usable() const;
};

/// How a body moves, in world.
struct BodyMotion {
  Vector3 centre_of_mass{Vector3::Zero()};
  Vector3 velocity{Vector3::Zero()};  ///< m/s
  Vector3 spin{Vector3::Zero()};      ///< rad/s

  /// Velocity of the body's point at `point`.
  [[nodiscard]] Vector3 velocity_at(const Vector3& point) const {
    return velocity + spin.cross(point - centre_of_mass);
  }
};

/// A body's tree where it is, and how it moves.
struct MovingTree {
  PlacedTree& tree;
  BodyMotion motion{};
};

/// Makes contacts of overlapping nodes, pair after pair, in memory that it keeps.
class ContactModelling {
 public:
  /// Adds to `contacts` those of two bodies whose nodes overlap, reduced and capped as `model`
  /// says; none when they are apart. `watched`, when there is one, gets the contact of every
  /// overlapping pair of nodes added.
  void add_pair_contacts(BodyPair bodies, const PairRefinement& pair, const MovingTree& a,
                         const MovingTree& b, const NormalFallbacks& fallbacks,
                         const ContactModel& model, std::vector<Contact>& contacts,
                         std::vector<Contact>* watched = nullptr);

  /// Adds the contacts of body `body` with each wall that its nodes reach, reduced and capped wall
  /// by wall. The normal is the wall's. `bodies` of each is {body, wall_index(wall)}, by rising
  /// wall.
  void add_wall_contacts(std::int32_t body, const PairRefinement& pair, const MovingTree& a,
                         const Enclosure& walls, const ContactModel& model,
                         std::vector<Contact>& contacts, std::vector<Contact>* watched = nullptr);

 private:
  void begin(BodyPair bodies, const ContactModel& model, const Vector3& fallback,
             std::vector<Contact>* watched);
  void add(const NodeContact& contact);
  void add_touches(std::span<const TouchPoint> touches);
  void add_contacts_of_spheres(const PairRefinement& pair, const MovingTree& a, const MovingTree& b,
                               const Vector3& fallback, unsigned terms);
  void add_reduced_to(std::vector<Contact>& contacts, int most, double size_m);

  std::shared_ptr<const ContactReduction> reduction_;  ///< that sums_ are of; none: average
  std::unique_ptr<ContactSums> sums_;
  std::vector<TouchPoint> reduced_;
  TorqueSpan torque_span_;
  BodyPair bodies_;
  std::vector<Contact>* watched_{nullptr};
};

}  // namespace impetus::inline collision
