// What becomes of a scene whose end nobody is shown: it goes on to its end without a display.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>

#include "experiments/run/scene_run.hpp"

namespace impetus::inline run {

/// A copy of the scene whose world is as it was at onset.
StagedScene scene_at_onset(const StagedScene& scene);

/// Two bodies of a scene, by their names.
using NamedPair = std::array<std::string, 2>;

/// Whether the two touch at any time until the scene's end, what is hidden of it included. It is
/// simulated from onset with all the work there is, so the scene alone decides: the same in a
/// window, in a page, in a replay and in a check. A name that there is not touches nothing.
bool touch_by_the_end(const StagedScene& scene, const NamedPair& names);

}  // namespace impetus::inline run
