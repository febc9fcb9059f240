// What a world cannot be made of.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "engine/dynamics/body.hpp"

namespace impetus::inline world {

/// What keeps a world from stepping these bodies, as a sentence that names the body; empty when
/// nothing does.
std::string problem_of(const std::vector<BodyModel>& models, const std::vector<BodyState>& states);

}  // namespace impetus::inline world
