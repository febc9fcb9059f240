// The bodies at the contacts of a step, as a response sees them: what stays as it is while impulses
// change the momenta is found once, and velocities follow the momenta push by push.
//
// Invariant: the velocities kept are those of the states, to the bit, as `velocity` and
// `angular_velocity` give them (body.hpp).
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/collision/contact_model.hpp"
#include "engine/dynamics/body.hpp"

namespace impetus::inline dynamics {

/// A body that one contact or more touches.
struct ContactBody {
  std::size_t index{0};  ///< in the world
  double inverse_mass{0.0};
  Matrix3 inverse_inertia{Matrix3::Zero()};  ///< in world
  Vector3 velocity{Vector3::Zero()};
  Vector3 spin{Vector3::Zero()};
  double speed_m_s{0.0};   ///< when it was gathered
  double spin_rad_s{0.0};  ///< likewise

  [[nodiscard]] bool moves() const { return inverse_mass > 0.0; }
};

/// A contact, its bodies by their places in `ContactBodies` (none: a wall) and their arms, from the
/// centres of mass (metres).
struct ContactArms {
  static constexpr std::int32_t kNone = -1;

  std::int32_t a{kNone};
  std::int32_t b{kNone};
  Vector3 normal{Vector3::UnitX()};
  Vector3 arm_a{Vector3::Zero()};
  Vector3 arm_b{Vector3::Zero()};
};

/// Keeps its arrays from one step to the next.
class ContactBodies {
 public:
  /// Looks anew at the contacts and the bodies they touch.
  void gather(const std::vector<Contact>& contacts, const std::vector<BodyModel>& models,
              const std::vector<BodyState>& states);

  [[nodiscard]] std::size_t contact_count() const { return contacts_.size(); }
  [[nodiscard]] const ContactArms& contact(std::size_t i) const { return contacts_[i]; }
  [[nodiscard]] std::size_t body_count() const { return bodies_.size(); }
  [[nodiscard]] const ContactBody& body(std::int32_t place) const {
    return bodies_[static_cast<std::size_t>(place)];
  }
  [[nodiscard]] bool moves(std::int32_t place) const {
    return place != ContactArms::kNone && body(place).moves();
  }

  /// Whether the contact is between the bodies that the one before it is between.
  [[nodiscard]] bool is_like_the_last(std::size_t contact) const {
    return contact > 0 && contacts_[contact].a == contacts_[contact - 1].a &&
           contacts_[contact].b == contacts_[contact - 1].b;
  }

  /// As separation_speed() (impulse.hpp).
  [[nodiscard]] double separation_speed(std::size_t contact) const;

  /// What the bodies of a contact brought to it when they were gathered: their speeds and those of
  /// their spins (m/s).
  [[nodiscard]] double incoming_speed(std::size_t contact) const;

  /// How much an impulse of 1 N s along the normal changes the separation speed (1/kg).
  [[nodiscard]] double give(std::size_t contact) const;

  /// Pushes the bodies of a contact apart by `impulse_Ns` along its normal.
  void push(std::size_t contact, double impulse_Ns, std::vector<BodyState>& states);

  /// Follows what somebody else did to the momenta of the body.
  void follow(std::int32_t place, const std::vector<BodyState>& states);

 private:
  std::int32_t place_of(std::int32_t body, const std::vector<BodyModel>& models,
                        const std::vector<BodyState>& states);
  [[nodiscard]] Vector3 point_velocity(std::int32_t place, const Vector3& arm) const;
  void push_body(std::int32_t place, const Vector3& arm, const Vector3& impulse,
                 std::vector<BodyState>& states);

  std::vector<ContactArms> contacts_;
  std::vector<ContactBody> bodies_;  ///< in the order in which contacts name them
  std::vector<std::int32_t> place_of_body_;
};

}  // namespace impetus::inline dynamics
