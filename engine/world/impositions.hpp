// Manipulations that are not physics, done to bodies where they collide: a hold, a change of spin.
//
// Each is asked for by the world's settings, done after the response, and said in the report.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "engine/world/step.hpp"
#include "engine/world/world_settings.hpp"

namespace impetus::inline world {

class Impositions {
 public:
  /// Holds the bodies of every collision that began and was responded to; adds the spin at the
  /// first collision of bodies 0 and 1 that was, if it is handled at the spin's level. Does nothing
  /// that `settings` does not ask for.
  void impose(const WorldSettings& settings, const std::vector<BodyModel>& models,
              std::vector<CollisionReport>& collisions, std::vector<BodyState>& states);

 private:
  void spin(const ImposedSpinRule& rule, const std::vector<BodyModel>& models,
            CollisionReport& collision, std::vector<BodyState>& states);

  bool has_spun_{false};  ///< the first collision was, at whatever level
};

}  // namespace impetus::inline world
