// What a step of a world tells Python, and the trees of its bodies: kept by themselves, for the
// world's own report is overwritten by the next step.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/world/world.hpp"
#include "experiments/record/wall_names.hpp"

namespace impetus::inline python {

/// One collision of a step, by the bodies' names.
struct CollisionOfPython {
  std::string body_a;
  std::string body_b;
  CollisionReport report;
  std::vector<ReportedContact> contacts;
};

/// What a step told, kept by itself: the world's own report is overwritten by the next.
struct StepOfPython {
  std::int64_t number{0};
  StepReport report;
  std::vector<CollisionOfPython> collisions;
};

/// `bodies` are the names of the world's.
StepOfPython step_of(std::int64_t number, const StepReport& report,
                     const std::vector<std::string>& bodies, WallNaming walls);

/// A tree that outlives the world it is of.
struct TreeOfPython {
  std::shared_ptr<const VolumeTree> tree;
};

}  // namespace impetus::inline python
