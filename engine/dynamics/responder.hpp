// The response to the contacts of a step, by either method, in arrays that outlive the step.
//
//   contacts --gather--> bodies at contacts --in turn | island by island--> momenta, impulses
//
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "engine/dynamics/contact_bodies.hpp"
#include "engine/dynamics/impulse.hpp"
#include "engine/dynamics/impulses_in_turn.hpp"
#include "engine/dynamics/impulses_together.hpp"
#include "engine/dynamics/islands.hpp"

namespace impetus::inline dynamics {

/// What it did in one step changes nothing of what it does in another: a memory of sizes alone.
/// Once it has seen as many contacts and bodies as it will, it allocates nothing.
class Responder {
 public:
  /// Applies impulses to `states`, as respond() or respond_together() and the rules say; a
  /// restitution in [0, 1] for each contact. The result is valid until the next call.
  const ResponseResult& respond(const std::vector<Contact>& contacts,
                                const std::vector<double>& restitutions, const ResponseRules& rules,
                                const std::vector<BodyModel>& models,
                                std::vector<BodyState>& states);

 private:
  void note_incoming();
  void respond_in_turn(const std::vector<double>& restitutions, const ResponseRules& rules,
                       std::vector<BodyState>& states);
  void respond_together(const std::vector<Contact>& contacts,
                        const std::vector<double>& restitutions, const ResponseRules& rules,
                        std::vector<BodyState>& states);
  void note_residual();

  ContactBodies bodies_;
  Islands islands_;
  ImpulsesInTurn<ContactBodies> in_turn_;
  ImpulsesTogether together_;
  std::vector<std::size_t> all_;
  ResponseResult result_;
};

}  // namespace impetus::inline dynamics
