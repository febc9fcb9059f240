// SPDX-License-Identifier: MIT
#include "engine/dynamics/impulse.hpp"

#include <algorithm>

#include "engine/dynamics/contact_bodies.hpp"
#include "engine/dynamics/responder.hpp"

namespace impetus::inline dynamics {

double separation_speed(const Contact& contact, const std::vector<BodyModel>& models,
                        const std::vector<BodyState>& states) {
  ContactBodies bodies;
  bodies.gather({contact}, models, states);
  return bodies.separation_speed(0);
}

TouchPoint net_contact(const std::vector<Contact>& contacts,
                       const std::vector<double>& impulse_Ns) {
  TouchPoint net{Vector3::Zero(), Vector3::Zero(), 0.0};
  double sum_Ns = 0.0;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    net.normal += impulse_Ns[i] * contacts[i].touch.normal;
    net.point += impulse_Ns[i] * contacts[i].touch.point;
    sum_Ns += impulse_Ns[i];
  }
  if (!(net.normal.norm() > 0.0)) {
    return std::max_element(
               contacts.begin(), contacts.end(),
               [](const Contact& x, const Contact& y) { return x.touch.depth_m < y.touch.depth_m; })
        ->touch;
  }
  net.normal.normalize();
  net.point /= sum_Ns;
  return net;
}

}  // namespace impetus::inline dynamics
