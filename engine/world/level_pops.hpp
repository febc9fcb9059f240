// Pops: pairs that touch at a coarser level than in the step before, and how visible that is.
//
// Bounds that grow at once push bodies apart that did not move; bounds that shrink are rarely
// noticed. (Dingliana 2002, sec. 5.3.1)
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "engine/dynamics/body.hpp"
#include "engine/scheduling/priority.hpp"

namespace impetus::inline world {

/// A pair that touches at a coarser level than in the step before.
struct LevelPop {
  BodyPair bodies;
  int from{0};
  int to{0};
  double size_deg{0.0};  ///< visual angle of what its bounds grew by
};

/// A pair that touches: the level its contacts are of, and where they are.
struct TouchingLevel {
  BodyPair bodies;  ///< b is a wall when is_wall(b)
  int level{0};
  Vector3 place{Vector3::Zero()};
};

class LevelMemory {
 public:
  /// Adds the pops from the pairs noted before to those of this step, in the order of `touching`,
  /// which is sorted by bodies. Their size is how much more both trees' fit errors are at the level
  /// they fell to, seen where they touch.
  void note(const std::vector<TouchingLevel>& touching, const std::vector<BodyModel>& models,
            const Viewer& viewer, std::vector<LevelPop>& pops);

 private:
  std::vector<TouchingLevel> before_;
};

}  // namespace impetus::inline world
