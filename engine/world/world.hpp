// The world: bodies, and the step that moves them and handles their collisions within a budget.
//
//   move ─> pair ─> prioritise ─> refine ─> model ─> respond ─> remember        (phases.hpp)
//
// A step is a pure function of the state, the input and the work granted: it reads no clock and
// no file, and gives the same bits on every machine. (Dingliana 2002, ch. 3)
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "engine/scheduling/work_meter.hpp"
#include "engine/scheduling/workers.hpp"
#include "engine/world/step.hpp"
#include "engine/world/step_memory.hpp"
#include "engine/world/world_settings.hpp"
#include "engine/world/world_state.hpp"

namespace impetus::inline world {

/// Bodies that move, collide and respond, step by step.
class World {
 public:
  /// `states` are the bodies' states at time zero, one per model. Throws std::invalid_argument on
  /// an unequal number, a body or state that it cannot step (world_state.hpp), or settings out of
  /// range.
  World(std::vector<BodyModel> models, std::vector<BodyState> states, WorldSettings settings);

  /// What it returns stays until the next step, and as long as the world does. Throws
  /// std::invalid_argument unless `input.dt_s` is a finite number, 0 or more; and what a metric, an
  /// order of work or a reduction of the caller's own throws: the bodies are then somewhere within
  /// the step, and the world is to be made anew.
  const StepReport& step(const StepInput& input, WorkMeter& meter);

  [[nodiscard]] const std::vector<BodyModel>& models() const { return state_.models; }
  [[nodiscard]] const std::vector<BodyState>& states() const { return state_.states; }
  [[nodiscard]] const WorldSettings& settings() const { return settings_; }
  [[nodiscard]] double kinetic_energy_J() const;  ///< of all bodies

  /// Another schedule from the next step on. Throws std::invalid_argument when it is out of range.
  void set_schedule(Schedule schedule);

  /// The same of how contacts are reduced, of fast bodies, of the response, of rotation and of what
  /// work costs.
  void set_contacts(ContactModel contacts);
  void set_tunnelling(Tunnelling tunnelling) { settings_.tunnelling = tunnelling; }
  void set_response(ResponseMethod response);
  void set_rotation(Rotation rotation) { settings_.rotation = rotation; }
  void set_costs(const WorkCosts& costs);

  /// Steps by the rules of recordings of this format from now on (WorldSettings::recording_format).
  /// Throws std::invalid_argument for one that is older than kOldestRecordingFormat, or newer than
  /// this library.
  void set_recording_format(int format);

  /// Who helps with steps from now on, or nobody: the search for entries is shared among them.
  /// Whatever a step does and reports is the same with any number, bit for bit, of the same work
  /// granted. A copy of the world has none.
  void share_work_with(std::shared_ptr<Workers> workers) { memory_.workers = std::move(workers); }

  /// Whether steps report the contacts of all overlapping nodes, for drawing: changes nothing else.
  void watch_node_contacts(bool watch) { state_.watches_node_contacts = watch; }

  /// Whether the world lends the pairs of its steps, for drawing: changes nothing else.
  void watch_pairs(bool watch) { state_.watches_pairs = watch; }

  /// The pairs that the last step looked at, as it shared its work among them: by list, where
  /// persistence had them, and by falling priority within each. None when they were not watched.
  /// They stay until the next step.
  [[nodiscard]] const std::vector<ScheduledPair>& pairs() const { return memory_.pairs; }

  /// How many nodes of the bodies' trees all steps so far have transformed into the world.
  [[nodiscard]] std::int64_t nodes_transformed() const;

  /// For what moves a body from outside, as in tests and in what somebody imagines.
  [[nodiscard]] std::span<BodyState> mutable_states() { return state_.states; }

 private:
  /// Throws std::invalid_argument, changing nothing, where the settings do not go together then.
  template <typename Value>
  void change(Value WorldSettings::*setting, Value value);

  WorldSettings settings_;
  WorldState state_;
  StepMemory memory_;
};

}  // namespace impetus::inline world
