// Free motion: momenta are constant, so the position is exact and only the rotation is integrated.
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/dynamics/body.hpp"

namespace impetus {

/// Moves a body through `dt_s` seconds, less what an imposed hold still takes from it. Rotation is
/// by the implicit midpoint rule with four fixed iterations and the Cayley map, so it uses no
/// trigonometry and leaves the angular momentum untouched. A body without spin skips it.
/// Returns the distance its centre moved (metres).
double advance(const BodyModel& model, BodyState& state, double dt_s);

/// The pose at `fraction` of the step from `before` to `after`, for drawing alone.
Pose between(const BodyState& before, const BodyState& after, double fraction);

}  // namespace impetus
