// What a step works with, kept from one step to the next so that a step allocates nothing once its
// scene has been as full as it gets.
//
// Nothing here decides anything: each part is filled anew before it is read. A copy of a world
// starts with an empty memory, and so does a world that is assigned to.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "engine/collision/broad_phase.hpp"
#include "engine/collision/list_refinement.hpp"
#include "engine/dynamics/motion.hpp"
#include "engine/dynamics/responder.hpp"
#include "engine/dynamics/stop_at_entry.hpp"
#include "engine/world/collision_reports.hpp"
#include "engine/world/level_pops.hpp"
#include "engine/world/step_order.hpp"

namespace impetus::inline world {

/// Pairs that are refined, in objects that are used again.
class RefinedPairs {
 public:
  void clear() {
    for (RefinedPair& pair : all()) {
      pair.refinement.give_memory_back();
    }
    count_ = 0;
  }

  RefinedPair& add() {
    if (count_ == pairs_.size()) {
      pairs_.emplace_back().refinement.take_memory_from(*store_);
    }
    return pairs_[count_++];
  }
  [[nodiscard]] std::span<RefinedPair> all() { return {pairs_.data(), count_}; }

 private:
  std::unique_ptr<NodeBlockStore> store_{std::make_unique<NodeBlockStore>()};
  std::vector<RefinedPair> pairs_;
  std::size_t count_{0};
};

struct StepMemory {
  StepMemory() = default;
  StepMemory(const StepMemory& /*other*/) : StepMemory() {}
  StepMemory(StepMemory&&) = default;
  StepMemory& operator=(const StepMemory& /*other*/) { return *this; }
  StepMemory& operator=(StepMemory&&) = default;
  ~StepMemory() = default;

  std::vector<MovedBound> bounds;
  std::vector<PairBounds> candidates;
  std::vector<PairBounds> stoppable;  ///< where there are figures: those that are of no part
  EntryMemory entries;  ///< its result is that of the last step in which bodies could be stopped
  StepOrder order;
  RefinedPairs refined;
  ListRefinement refinement;
  ContactModelling modelling;
  ModelledCollisions modelled;
  std::vector<Fall> falls;        ///< by body; none without gravity
  std::vector<Contact> contacts;  ///< that are responded to
  std::vector<double> restitutions;
  Responder responder;
  std::vector<BodyPair> touching;
  std::vector<TouchingLevel> touching_levels;
  StepReport report;
};

}  // namespace impetus::inline world
