// Impulses in turn as the method reads, every contact in every pass.
// SPDX-License-Identifier: MIT
#include "tests/engine/once.hpp"
#include "tests/engine/plain_response.hpp"

#include <algorithm>
#include <numeric>

namespace impetus::plain {
namespace {

/// One body at a contact; walls have no side.
struct Side {
  const BodyModel& model;
  BodyState& state;
  Vector3 arm;
};

/// Velocity of the body's point at `point`; a wall stands still.
Vector3 point_velocity(std::int32_t index, const Vector3& point,
                       const std::vector<BodyModel>& models, const std::vector<BodyState>& states) {
  if (is_wall(index)) {
    return Vector3::Zero();
  }
  const auto body = static_cast<std::size_t>(index);
  const Vector3 arm = point - states[body].pose.position;
  return velocity(models[body], states[body]) +
         angular_velocity(models[body], states[body]).cross(arm);
}

/// How much an impulse of 1 N s along n changes the speed of the side's point along n (1/kg).
double mobility(const Side& side, const Vector3& normal) {
  const Vector3 turn =
      world_inverse_inertia(side.model, side.state) * Vector3(side.arm.cross(normal));
  return side.model.inverse_mass + normal.dot(turn.cross(side.arm));
}

Side side_of(std::int32_t index, const Contact& contact, const std::vector<BodyModel>& models,
             std::vector<BodyState>& states) {
  const auto body = static_cast<std::size_t>(index);
  return {models[body], states[body], contact.touch.point - states[body].pose.position};
}

void push(std::int32_t index, const Contact& contact, const Vector3& impulse,
          const std::vector<BodyModel>& models, std::vector<BodyState>& states) {
  if (is_wall(index)) {
    return;
  }
  const Side side = side_of(index, contact, models, states);
  if (side.model.inverse_mass > 0.0) {
    side.state.linear_momentum += impulse;
    side.state.angular_momentum += side.arm.cross(impulse);
  }
}

/// Applies the single-contact impulse (eq. 3.1) if the contact approaches; returns its size.
double apply_if_approaching(const Contact& contact, double restitution,
                            const std::vector<BodyModel>& models, std::vector<BodyState>& states) {
  const double speed = plain::separation_speed(contact, models, states);
  if (!(speed < 0.0)) {
    return 0.0;
  }
  const Vector3& normal = contact.touch.normal;
  double give = 0.0;
  for (const std::int32_t index : {contact.bodies.a, contact.bodies.b}) {
    give += is_wall(index) ? 0.0 : mobility(side_of(index, contact, models, states), normal);
  }
  if (!(give > 0.0)) {
    return 0.0;
  }
  const double impulse_Ns = -(1.0 + restitution) * speed / give;
  push(contact.bodies.a, contact, impulse_Ns * normal, models, states);
  push(contact.bodies.b, contact, -impulse_Ns * normal, models, states);
  return impulse_Ns;
}

/// What the bodies of a contact bring to it: their speeds and those of their spins (m/s).
double incoming_speed(const Contact& contact, const std::vector<BodyModel>& models,
                      const std::vector<BodyState>& states) {
  double speed = 0.0;
  for (const std::int32_t index : {contact.bodies.a, contact.bodies.b}) {
    if (is_wall(index)) {
      continue;
    }
    const auto body = static_cast<std::size_t>(index);
    const Vector3 arm = contact.touch.point - states[body].pose.position;
    speed += velocity(models[body], states[body]).norm() +
             angular_velocity(models[body], states[body]).norm() * arm.norm();
  }
  return speed;
}

}  // namespace

double separation_speed(const Contact& contact, const std::vector<BodyModel>& models,
                        const std::vector<BodyState>& states) {
  const Vector3 relative = point_velocity(contact.bodies.a, contact.touch.point, models, states) -
                           point_velocity(contact.bodies.b, contact.touch.point, models, states);
  return contact.touch.normal.dot(relative);
}

ResponseResult incoming(const std::vector<Contact>& contacts, const std::vector<BodyModel>& models,
                        const std::vector<BodyState>& states) {
  ResponseResult result;
  result.impulse_Ns.assign(contacts.size(), 0.0);
  for (const Contact& contact : contacts) {
    result.fastest_m_s = std::max(result.fastest_m_s, incoming_speed(contact, models, states));
    result.approach_m_s.push_back(std::max(0.0, -plain::separation_speed(contact, models, states)));
  }
  return result;
}

void measure_residual(const std::vector<Contact>& contacts, const std::vector<BodyModel>& models,
                      const std::vector<BodyState>& states, ResponseResult& result) {
  for (const Contact& contact : contacts) {
    result.residual_approach_m_s =
        std::max(result.residual_approach_m_s, -plain::separation_speed(contact, models, states));
  }
  if (result.residual_approach_m_s <= kNegligibleApproach * result.fastest_m_s) {
    result.residual_approach_m_s = 0.0;
  }
}

void respond_in_turn(const std::vector<Contact>& contacts, const std::vector<std::size_t>& members,
                     const std::vector<double>& restitutions, const std::vector<BodyModel>& models,
                     std::vector<BodyState>& states, std::vector<double>& impulse_Ns) {
  const auto pass = [&](bool plastic) {
    bool changed = false;
    for (const std::size_t i : members) {
      const double added =
          apply_if_approaching(contacts[i], plastic ? 0.0 : restitutions[i], models, states);
      impulse_Ns[i] += added;
      changed = changed || added > 0.0;
    }
    return changed;
  };
  const std::size_t passes = 2 * members.size();
  for (std::size_t done = 0; done < passes; ++done) {
    if (!pass(/*plastic=*/false)) {
      return;
    }
  }
  pass(/*plastic=*/true);
}

ResponseResult respond(const std::vector<Contact>& contacts,
                       const std::vector<double>& restitutions,
                       const std::vector<BodyModel>& models, std::vector<BodyState>& states) {
  ResponseResult result = plain::incoming(contacts, models, states);
  std::vector<std::size_t> all(contacts.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  plain::respond_in_turn(contacts, all, restitutions, models, states, result.impulse_Ns);
  plain::measure_residual(contacts, models, states, result);
  return result;
}

}  // namespace impetus::plain
