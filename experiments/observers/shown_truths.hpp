// What a trial really showed, as a simulated participant may see it.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "experiments/record/record.hpp"
#include "experiments/record/staged_scene.hpp"

namespace impetus::inline observers {

/// The first collision of two bodies; null when there was none.
const CollisionRecord* first_meeting(const AttemptRecord& shown);

/// The longest freeze at contact, ms; 0: none.
double longest_delay_ms(const AttemptRecord& shown);

/// Between the two bodies of a launch that is imposed where the first stops, along their way: of
/// what is drawn, or of their bounds at a level of their trees. Below 0: it is over the second.
double launch_gap_arcmin(const StagedScene& scene, std::optional<int> level);

/// The widest gap between two bodies that collide, as seen, less its hidden share.
double widest_gap_arcmin(const AttemptRecord& shown, const StagedScene& scene);

}  // namespace impetus::inline observers
