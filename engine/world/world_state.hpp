// What a world is from step to step: its bodies, and what it remembers of the last step.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/collision/broad_phase.hpp"
#include "engine/collision/placed_tree.hpp"
#include "engine/dynamics/body.hpp"
#include "engine/dynamics/finite_states.hpp"
#include "engine/figures/figures.hpp"
#include "engine/scheduling/priority_memory.hpp"
#include "engine/world/world_settings.hpp"

namespace impetus::inline world {

/// A value that is rarely there, kept elsewhere: whoever does without pays for a pointer. A copy
/// copies what it points to.
template <typename Value>
class ValuePointer {
 public:
  ValuePointer() = default;
  explicit ValuePointer(Value value) : value_(std::make_unique<Value>(std::move(value))) {}
  ValuePointer(const ValuePointer& other)
      : value_(other.value_ ? std::make_unique<Value>(*other.value_) : nullptr) {}
  ValuePointer(ValuePointer&&) noexcept = default;
  ValuePointer& operator=(const ValuePointer& other) {
    *this = ValuePointer(other);
    return *this;
  }
  ValuePointer& operator=(ValuePointer&&) noexcept = default;
  ~ValuePointer() = default;

  explicit operator bool() const { return value_ != nullptr; }
  Value* operator->() { return value_.get(); }
  const Value* operator->() const { return value_.get(); }

 private:
  std::unique_ptr<Value> value_;
};

/// What a world remembers of two bodies, or of a body and a wall, that touched in a step.
struct TouchingPair {
  BodyPair bodies;
  Vector3 normal{Vector3::UnitX()};  ///< of their deepest contact
  int level{0};                      ///< of refinement, that their contacts are of
};

/// What keeps a world from stepping these bodies, as a sentence that names the body; empty when
/// nothing does.
std::string problem_of(const std::vector<BodyModel>& models, const std::vector<BodyState>& states);

/// What the phases of a step change for good; a copy is a snapshot.
struct WorldState {
  /// `states` are the bodies' states at time zero, one per model. Throws std::invalid_argument on
  /// what World's own constructor names.
  WorldState(std::vector<BodyModel> models, std::vector<BodyState> states,
             const WorldSettings& settings);

  [[nodiscard]] bool is_of_figure(BodyPair bodies) const {
    return figures && figures->has_part(bodies);
  }

  /// What is remembered of bodies that touched when the step before ended; null of others.
  [[nodiscard]] const TouchingPair* touched_before(BodyPair bodies) const;

  std::vector<BodyModel> models;
  std::vector<BodyState> states;
  FiniteStates finite;             ///< who is out, and the states that the step began with
  std::vector<PlacedTree> placed;  ///< by body
  ValuePointer<Figures> figures;   ///< none: nothing
  SweepAndPrune broad_phase;
  PriorityMemory priorities;
  std::vector<TouchingPair> touching;  ///< when the last step ended, sorted by bodies
  /// Of those that the last step had no work left for, the first in line.
  std::optional<BodyPair> next_to_begin;
  bool some_pass_through{false};  ///< of the bodies
  bool have_met{false};  ///< bodies 0 and 1 had the collision that spin and rebound wait for
  bool was_cut{false};   ///< some step so far was granted less than it asked for, but refinement
  bool watches_node_contacts{false};
  bool watches_pairs{false};

 private:
  void order_bodies();
};

}  // namespace impetus::inline world
