// SPDX-License-Identifier: MIT
#include "engine/figures/hinged_responder.hpp"

#include <algorithm>
#include <numeric>

namespace impetus::inline figures {

const ResponseResult& HingedResponder::respond(const std::vector<Contact>& contacts,
                                               const std::vector<HingeStop>& stops,
                                               const std::vector<double>& restitutions,
                                               const ResponseRules& rules,
                                               const std::vector<BodyModel>& models,
                                               const FiguresInMotion& figures,
                                               std::vector<BodyState>& states) {
  bodies_.gather(contacts, stops, models, states, figures);
  const std::size_t count = bodies_.contact_count();
  restitutions_.assign(restitutions.begin(), restitutions.end());
  restitutions_.resize(count, 0.0);
  impulses_.assign(count, 0.0);
  result_.approach_m_s.clear();
  result_.fastest_m_s = 0.0;
  result_.residual_approach_m_s = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    result_.fastest_m_s = std::max(result_.fastest_m_s, bodies_.incoming_speed(i));
    if (i < contacts.size()) {
      result_.approach_m_s.push_back(std::max(0.0, -bodies_.separation_speed(i)));
    }
  }
  all_.resize(count);
  std::iota(all_.begin(), all_.end(), std::size_t{0});
  in_turn_.look_at(bodies_);
  in_turn_.respond(all_, restitutions_, rules, bodies_, states, impulses_);
  for (std::size_t i = 0; i < count; ++i) {
    result_.residual_approach_m_s =
        std::max(result_.residual_approach_m_s, -bodies_.separation_speed(i));
  }
  if (result_.residual_approach_m_s <= kNegligibleApproach * result_.fastest_m_s) {
    result_.residual_approach_m_s = 0.0;
  }
  result_.impulse_Ns.assign(impulses_.begin(),
                            impulses_.begin() + static_cast<std::ptrdiff_t>(contacts.size()));
  return result_;
}

}  // namespace impetus::inline figures
