// SPDX-License-Identifier: MIT
#include "engine/dynamics/contact_bodies.hpp"

namespace impetus::inline dynamics {
namespace {

double mobility(const ContactBody& body, const Vector3& arm, const Vector3& normal) {
  const Vector3 turn = body.inverse_inertia * Vector3(arm.cross(normal));
  return body.inverse_mass + normal.dot(turn.cross(arm));
}

}  // namespace

void ContactBodies::gather(const std::vector<Contact>& contacts,
                           const std::vector<BodyModel>& models,
                           const std::vector<BodyState>& states) {
  for (const ContactBody& body : bodies_) {
    if (body.index < place_of_body_.size()) {
      place_of_body_[body.index] = ContactArms::kNone;
    }
  }
  place_of_body_.resize(models.size(), ContactArms::kNone);
  bodies_.clear();
  contacts_.clear();
  for (const Contact& contact : contacts) {
    ContactArms arms;
    arms.normal = contact.touch.normal;
    arms.a = place_of(contact.bodies.a, models, states);
    arms.b = place_of(contact.bodies.b, models, states);
    if (arms.a != ContactArms::kNone) {
      arms.arm_a = contact.touch.point - states[body(arms.a).index].pose.position;
    }
    if (arms.b != ContactArms::kNone) {
      arms.arm_b = contact.touch.point - states[body(arms.b).index].pose.position;
    }
    contacts_.push_back(arms);
  }
}

std::int32_t ContactBodies::place_of(std::int32_t body, const std::vector<BodyModel>& models,
                                     const std::vector<BodyState>& states) {
  if (is_wall(body)) {
    return ContactArms::kNone;
  }
  const auto index = static_cast<std::size_t>(body);
  std::int32_t& place = place_of_body_[index];
  if (place == ContactArms::kNone) {
    place = static_cast<std::int32_t>(bodies_.size());
    ContactBody added;
    added.index = index;
    added.inverse_mass = models[index].inverse_mass;
    added.inverse_inertia = world_inverse_inertia(models[index], states[index]);
    bodies_.push_back(added);
    follow(place, states);
    ContactBody& gathered = bodies_.back();
    gathered.speed_m_s = gathered.velocity.norm();
    gathered.spin_rad_s = gathered.spin.norm();
  }
  return place;
}

void ContactBodies::follow(std::int32_t place, const std::vector<BodyState>& states) {
  ContactBody& body = bodies_[static_cast<std::size_t>(place)];
  body.velocity = body.inverse_mass * states[body.index].linear_momentum;
  body.spin = body.inverse_inertia * states[body.index].angular_momentum;
}

Vector3 ContactBodies::point_velocity(std::int32_t place, const Vector3& arm) const {
  if (place == ContactArms::kNone) {
    return Vector3::Zero();
  }
  return body(place).velocity + body(place).spin.cross(arm);
}

double ContactBodies::separation_speed(std::size_t contact) const {
  const ContactArms& at = contacts_[contact];
  const Vector3 relative = point_velocity(at.a, at.arm_a) - point_velocity(at.b, at.arm_b);
  return at.normal.dot(relative);
}

double ContactBodies::incoming_speed(std::size_t contact) const {
  const ContactArms& at = contacts_[contact];
  double speed = 0.0;
  if (at.a != ContactArms::kNone) {
    speed += body(at.a).speed_m_s + body(at.a).spin_rad_s * at.arm_a.norm();
  }
  if (at.b != ContactArms::kNone) {
    speed += body(at.b).speed_m_s + body(at.b).spin_rad_s * at.arm_b.norm();
  }
  return speed;
}

double ContactBodies::give(std::size_t contact) const {
  const ContactArms& at = contacts_[contact];
  double give = 0.0;
  give += at.a == ContactArms::kNone ? 0.0 : mobility(body(at.a), at.arm_a, at.normal);
  give += at.b == ContactArms::kNone ? 0.0 : mobility(body(at.b), at.arm_b, at.normal);
  return give;
}

void ContactBodies::push(std::size_t contact, double impulse_Ns, std::vector<BodyState>& states) {
  const ContactArms& at = contacts_[contact];
  push_body(at.a, at.arm_a, impulse_Ns * at.normal, states);
  push_body(at.b, at.arm_b, -impulse_Ns * at.normal, states);
}

void ContactBodies::push_body(std::int32_t place, const Vector3& arm, const Vector3& impulse,
                              std::vector<BodyState>& states) {
  if (!moves(place)) {
    return;
  }
  BodyState& state = states[body(place).index];
  state.linear_momentum += impulse;
  state.angular_momentum += arm.cross(impulse);
  follow(place, states);
}

}  // namespace impetus::inline dynamics
