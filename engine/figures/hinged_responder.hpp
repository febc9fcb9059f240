// The response to the contacts of a step in which there are figures, and to the limits of their
// hinges: by impulses in turn, as Responder does without.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "engine/dynamics/impulses_in_turn.hpp"
#include "engine/figures/hinged_bodies.hpp"

namespace impetus::inline figures {

class HingedResponder {
 public:
  /// Applies impulses to `states`; a restitution in [0, 1] for each contact, none for the limits of
  /// hinges. The result is of the contacts, and valid until the next call. Of neighbours that are
  /// folded together it tells angles: speeds in rad/s, impulses in N m s.
  const ResponseResult& respond(const std::vector<Contact>& contacts,
                                const std::vector<HingeStop>& stops,
                                const std::vector<double>& restitutions, const ResponseRules& rules,
                                const std::vector<BodyModel>& models,
                                const FiguresInMotion& figures, std::vector<BodyState>& states);

 private:
  HingedBodies bodies_;
  ImpulsesInTurn<HingedBodies> in_turn_;
  std::vector<std::size_t> all_;
  std::vector<double> restitutions_;
  std::vector<double> impulses_;
  ResponseResult result_;
};

}  // namespace impetus::inline figures
