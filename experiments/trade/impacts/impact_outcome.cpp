// SPDX-License-Identifier: MIT
#include "experiments/trade/impacts/impact_outcome.hpp"

#include <array>
#include <cmath>

#include "engine/dynamics/impulse.hpp"
#include "engine/numerics/elementary_functions.hpp"

namespace impetus::inline trade {

ImpactOutcome outcome_of(const std::vector<Contact>& contacts, const ExactImpact& impact,
                         const ImpactPair& pair, Responder& responder) {
  const std::vector<BodyModel> models{pair.a.model, pair.b.model};
  std::vector<BodyState> states = impact.states;
  ResponseRules rules;
  rules.method = pair.response;
  const ResponseResult& result = responder.respond(
      contacts, std::vector<double>(contacts.size(), pair.restitution), rules, models, states);
  ImpactOutcome outcome;
  outcome.net = net_contact(contacts, result.impulse_Ns);
  for (std::size_t body = 0; body < models.size(); ++body) {
    outcome.velocity_m_s[body] = velocity(models[body], states[body]);
    outcome.spin_rad_s[body] = angular_velocity(models[body], states[body]);
  }
  return outcome;
}

ImpactErrors errors_of(const ImpactOutcome& found, const ImpactOutcome& reference,
                       const ExactImpact& impact, const ImpactPair& pair) {
  const Vector3& x = found.net.normal;
  const Vector3& y = reference.net.normal;
  const std::array<double, 2> radii_m{pair.a.look.radius_m, pair.b.look.radius_m};
  double linear = 0.0;
  double angular = 0.0;
  for (std::size_t body = 0; body < radii_m.size(); ++body) {
    linear += (found.velocity_m_s[body] - reference.velocity_m_s[body]).squaredNorm();
    angular += radii_m[body] * radii_m[body] *
               (found.spin_rad_s[body] - reference.spin_rad_s[body]).squaredNorm();
  }
  return {degrees(atan2_rad(x.cross(y).norm(), x.dot(y))),
          (found.net.point - reference.net.point).norm() / pair.size_m(),
          std::sqrt(linear) / impact.approach_m_s, std::sqrt(angular) / impact.approach_m_s};
}

}  // namespace impetus::inline trade
