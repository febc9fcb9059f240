// A recorded trial simulated twice, side by side: as it was, and as it would have been under other
// settings of the engine, with the same participant's gaze.
//
//   then   o──o──o──o──o──o      the recording, step by step: gaze, region, work granted
//   now    o──o──o               other settings, the same gaze, and a region and a budget by
//                 ╲o──o──o       their own rules
//
// Collisions count at the step in which they begin. The same pair beginning within a twentieth of a
// second in both is one collision; what is left happened only then, or only now. How visible a gap
// is goes by the part of it that nothing hides, and by where the participant looked: as many
// minutes of arc at the point of gaze would be as hard to resolve (eccentricity_metric.hpp).
//
// Nothing else is changed, and nothing of it is random: where the settings are the recorded ones,
// both are the same in every bit.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/collision/pair_refinement.hpp"
#include "experiments/record/record.hpp"
#include "experiments/record/staged_scene.hpp"
#include "experiments/run/replay.hpp"

namespace impetus::inline run {

inline constexpr double kMatchWithin_s = 0.05;

/// A collision where it began, and what could be seen of its error.
struct SeenCollision {
  std::int64_t step{0};
  BodyPair bodies;
  int level{0};
  StopReason stop{StopReason::kFinest};
  double gap_arcmin{0.0};      ///< between the drawn surfaces
  double visible_arcmin{0.0};  ///< the part of it that nothing hides
  /// The same, as hard to see at the point of gaze; of the screen's centre without a gaze.
  double at_gaze_arcmin{0.0};
};

/// One of the two simulations.
struct WhatIfCourse {
  std::vector<SeenCollision> collisions;  ///< by step, in the order of the step's report
  std::int64_t work_spent{0};             ///< units of work, over all steps
  std::int64_t steps_over_budget{0};      ///< whose coarsest levels cost more than was granted
  std::int64_t pops{0};                   ///< pairs that fell to a coarser level while they touched
  std::int64_t stopped_short{0};          ///< pairs stopped where they would have passed
  std::int64_t imposed_holds{0};
  std::int64_t imposed_spins{0};
};

/// A collision that both have, or one alone; places in their lists.
struct CollisionMatch {
  std::optional<std::size_t> then{};
  std::optional<std::size_t> now{};
};

/// Both simulations, their collisions matched, and when they parted.
struct WhatIf {
  WhatIfCourse then;
  WhatIfCourse now;
  std::vector<CollisionMatch> matches;          ///< by step, of the earlier of the two
  std::int64_t steps{0};                        ///< simulated, the start not counted
  std::optional<std::int64_t> parts_at{};       ///< first step whose states differ in any bit
  std::optional<std::int64_t> seen_apart_at{};  ///< and in which the eye could tell a body's place
  std::optional<Divergence> divergence{};       ///< `then` is not what was recorded: nothing counts
};

/// Simulates both through the recorded steps. `then` and `now` are the scene of the recording at
/// its start, under the recorded settings and the others; `seed` is the trial's. A step of `now` is
/// granted what its own budget says, or, where that goes by the clock, what was granted then. The
/// region is the recorded one where both have the same rule, and follows another participant's
/// gaze as it did then.
WhatIf what_if(StagedScene then, StagedScene now, const std::vector<StepRecord>& recorded,
               std::uint64_t seed);

/// Pairs off the collisions of the same bodies that begin at most `within_steps` apart, in their
/// order.
std::vector<CollisionMatch> matched(const std::vector<SeenCollision>& then,
                                    const std::vector<SeenCollision>& now,
                                    std::int64_t within_steps);

}  // namespace impetus::inline run
