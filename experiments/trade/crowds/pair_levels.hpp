// What each level of detail would leave of a step's collisions to be seen, pair by pair.
//
//   poses of a step ──> pairs whose roots overlap ──level by level──> work so far, error left
//
//   error left of a pair = what of it shows · e₂ / (e + e₂)       minutes of arc at the fovea
//
//   gap     what shows is the gap between the drawn surfaces, less its hidden share, as long as the
//           level says that the bodies touch; nothing once it says that they do not
//   bound   what shows is the visual angle of both trees' fit errors, which the gap cannot exceed
//
// e is the eccentricity of the gap, or of the collision, from where one looks: a gap counts by how
// often it exceeds what can just be seen there, in minutes of arc at the fovea. Its projected size
// is its visual angle. (Geisler and Perry 1998; Dingliana 2002, sec. 5.2.1)
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "experiments/record/staged_scene.hpp"

namespace impetus::inline trade {

/// In minutes of arc at the fovea.
struct VisibleError {
  double gap{0.0};
  double bound{0.0};
};

/// A pair that stands at one level.
struct PairAtLevel {
  std::int64_t work{0};  ///< on tests beyond the roots', until this level is complete (units)
  VisibleError left;
};

/// Two bodies whose roots overlap, or a body and the enclosure as a whole.
struct PairLevels {
  BodyPair bodies;
  std::vector<PairAtLevel> levels;  ///< from the root to where refinement is resolved
};

/// What the viewer sees, and where it looks.
struct Look {
  Viewer viewer;
  Fixation fixation;
};

/// The pairs of the scene's bodies in these poses, by their bodies. What tests cost is the
/// scene's own (WorldSettings::costs).
std::vector<PairLevels> pair_levels(const StagedScene& scene, const std::vector<Pose>& poses,
                                    const Look& look);

}  // namespace impetus::inline trade
