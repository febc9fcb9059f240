// The threshold that parts the collisions of a pilot in two lists of given shares.
//
//   pilot ──collisions of two bodies, measured──> threshold ──> pilot again ──> shares as wanted?
//
// Where lists differ in detail, the threshold changes what happens, so it is tried and, when it
// misses, found anew from that pilot. Collisions with walls are not counted: nothing is modelled of
// a wall's surface. (Dingliana 2002, sec. 6.3: "some sampling of the scene")
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/trees/tree_settings.hpp"
#include "experiments/design/plan.hpp"
#include "experiments/protocol/solve_task.hpp"
#include "experiments/scenes/shape_library.hpp"

namespace impetus::inline protocol {

/// Throws InputError when no threshold comes within the tolerance of the share.
std::vector<SolvedValue> solve_equal_lists(const SolveTask& task, ShapeLibrary& shapes,
                                           const Progress& progress);

}  // namespace impetus::inline protocol
