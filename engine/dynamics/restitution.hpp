// How much of an approach is given back, by the materials that meet.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "engine/collision/contact_model.hpp"
#include "engine/dynamics/body.hpp"

namespace impetus::inline dynamics {

/// The restitution of bodies of two materials (see BodyModel), in either order.
struct PairRestitution {
  int material{0};
  int other{0};
  double restitution{1.0};
};

/// Restitutions by pair of materials, and what holds for every other pair.
struct Restitutions {
  double otherwise{1.0};
  const std::vector<PairRestitution>& stated;
  int wall_material{0};

  [[nodiscard]] double of(int material, int other) const;

  /// Of each contact, in their order, instead of what `restitutions` held.
  void find(const std::vector<Contact>& contacts, const std::vector<BodyModel>& models,
            std::vector<double>& restitutions) const;
};

/// What is wrong with the list, as a sentence; empty when nothing is. Every restitution lies in
/// [0, 1], and no pair of materials is stated twice, in whichever order.
std::string problem_of(const std::vector<PairRestitution>& stated);

}  // namespace impetus::inline dynamics
