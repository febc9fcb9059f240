// The seven phases of a step, in their order: a source of this room each, named as its function.
//
//   move        bodies and figures move; momenta are exact           -> states, bounds
//   pair        swept bounds; fast pairs stop where they first touch -> candidates, in their order
//   prioritise  a metric per pair -> a priority list                 -> order
//   refine      while the meter grants work: the list furthest behind its share, its next pair, one
//               block of node-pair tests                             -> refined
//   model       contacts of the last complete level, reduced         -> report
//   respond     impulses; never add energy                           -> states, report
//   remember    who touches, and at which level; the hash            -> touching, report
//
// A phase reads what those before it left in the step's memory, and nothing else but the settings,
// the input and the world's state: so each can be made alone. (Dingliana 2002, ch. 3)
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/scheduling/work_meter.hpp"
#include "engine/world/step_memory.hpp"
#include "engine/world/world_settings.hpp"
#include "engine/world/world_state.hpp"

namespace impetus::inline world {

/// What the phases of one step work on.
struct Step {
  const WorldSettings& settings;
  const StepInput& input;
  WorldState& world;   ///< what the step changes for good
  StepMemory& memory;  ///< what phases hand to each other, and the report
  WorkMeter& meter;    ///< asked by every phase that can be interrupted

  /// The work of a phase, whose refusal is noted in the report.
  [[nodiscard]] PhaseWork work_of(WorkPhase phase) const {
    return {meter, phase, memory.report.grants};
  }

  /// The walls that end the ways of centres; null when none do.
  [[nodiscard]] const Enclosure* walls_of_centres() const {
    return settings.enclosure && !settings.has_rules_before(5) ? &*settings.enclosure : nullptr;
  }
};

/// Moves every body, and every figure as a whole, in as many parts of the step as the meter grants.
/// The way of a body's centre ends at a wall.
/// Bodies whose state is not finite are taken out, before and after they have moved.
void move_bodies(const Step& step);

/// Finds who may have met: two bodies, or a body and the enclosure. Of more pairs of bodies than
/// the meter grants, those that reach least into each other are left. Fast bodies stop where they
/// first touch, as far as the meter grants the search; it is part of the floor of refinement. All
/// trees are placed.
void pair_bodies(const Step& step);

/// Gives every candidate its list, which persistence may raise.
void prioritise_pairs(const Step& step);

/// Refines the pairs to their floor, and on for as long as the meter grants work.
void refine_pairs(const Step& step);

/// Reports the contacts of the pairs that overlap, and the folds of figures, by their bodies. Where
/// the meter does not grant them all: walls and folds in any case, and pairs by falling priority.
void model_contacts(const Step& step);

/// Gives the bodies of the reported contacts their impulses, and what the settings impose on them
/// beyond physics. Where the meter does not grant it all, the most visible contacts go on for as
/// long as it does, then those with walls, in any case, and nobody's centre is let through a wall.
/// A body whose state is not finite after it is taken out.
void respond_to_contacts(const Step& step);

/// Keeps who touches, for the next step; reports pops and the hash of the state.
void remember_contacts(const Step& step);

}  // namespace impetus::inline world
