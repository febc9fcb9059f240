// The seven phases of a step, in their order: a source of this room each, named as its function.
//
//   move        bodies and figures move; momenta are exact           -> states, bounds
//   pair        swept bounds; fast pairs stop where they first touch -> candidates, in a fixed
//   order prioritise  a metric per pair -> a priority list                 -> order refine while
//   the meter grants work: the list furthest behind its share, its next pair,
//               one block of node-pair tests                         -> refined
//   model       contacts of the last complete level, reduced         -> report
//   respond     impulses; never add energy                           -> states, report
//   remember    who touches, and at which level; the hash            -> touching, report
//
// A phase reads what those before it left in the step's memory, and nothing else but the settings,
// the input and the world's state: so each can be made alone. (Dingliana 2002, ch. 3)
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

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
};

/// Moves every body, and every figure as a whole. Bodies whose state is not finite are taken out,
/// before and after they have moved.
void move_bodies(const Step& step);

/// Finds who may have met: two bodies, or a body and the enclosure. Fast bodies stop where they
/// first touch, which is part of the floor of the work. All trees are placed.
void pair_bodies(const Step& step);

/// Gives every candidate its list, which persistence may raise.
void prioritise_pairs(const Step& step);

/// Refines the pairs to their floor, and on for as long as `meter` grants work.
void refine_pairs(const Step& step, WorkMeter& meter);

/// Reports the contacts of the pairs that overlap, and the folds of figures, by their bodies.
void model_contacts(const Step& step);

/// Gives the bodies of the reported contacts their impulses, and what the settings impose on them
/// beyond physics. A body whose state is not finite after it is taken out.
void respond_to_contacts(const Step& step);

/// Keeps who touches, for the next step; reports pops and the hash of the state.
void remember_contacts(const Step& step);

}  // namespace impetus::inline world
