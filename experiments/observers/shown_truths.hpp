// What a trial really showed, as a simulated participant may see it.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/record/record.hpp"
#include "experiments/record/staged_scene.hpp"

namespace impetus::inline observers {

/// The longest freeze at contact, ms; 0: none.
double longest_delay_ms(const AttemptRecord& shown);

/// The widest gap between two bodies that collide, as seen, less its hidden share.
double widest_gap_arcmin(const AttemptRecord& shown, const StagedScene& scene);

}  // namespace impetus::inline observers
