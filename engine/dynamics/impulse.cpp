// SPDX-License-Identifier: MIT
#include "engine/dynamics/impulse.hpp"

#include "engine/dynamics/contact_bodies.hpp"
#include "engine/dynamics/responder.hpp"

namespace impetus::inline dynamics {

double separation_speed(const Contact& contact, const std::vector<BodyModel>& models,
                        const std::vector<BodyState>& states) {
  ContactBodies bodies;
  bodies.gather({contact}, models, states);
  return bodies.separation_speed(0);
}

ResponseResult respond(const std::vector<Contact>& contacts,
                       const std::vector<double>& restitutions,
                       const std::vector<BodyModel>& models, std::vector<BodyState>& states) {
  return Responder().respond(contacts, restitutions, {}, models, states);
}

ResponseResult respond(const std::vector<Contact>& contacts, double restitution,
                       const std::vector<BodyModel>& models, std::vector<BodyState>& states) {
  return respond(contacts, std::vector<double>(contacts.size(), restitution), models, states);
}

}  // namespace impetus::inline dynamics
