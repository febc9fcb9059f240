// SPDX-License-Identifier: MIT
#include "engine/dynamics/simultaneous_response.hpp"

#include "engine/dynamics/responder.hpp"

namespace impetus::inline dynamics {

ResponseResult respond_together(const std::vector<Contact>& contacts,
                                const std::vector<double>& restitutions,
                                const std::vector<BodyModel>& models,
                                std::vector<BodyState>& states) {
  ResponseRules rules;
  rules.method = ResponseMethod::kTogether;
  return Responder().respond(contacts, restitutions, rules, models, states);
}

}  // namespace impetus::inline dynamics
