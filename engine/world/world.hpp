// The world: bodies, and the step that moves them and handles their collisions within a budget.
//
//   move        integrate bodies; momenta are exact
//   pair        swept bounds -> candidate pairs in a fixed order
//   prioritise  a metric per pair -> a priority list, and an order within it
//   refine      while the meter grants work: the list furthest behind its share, its next pair,
//               one block of node-pair tests
//   model       contacts of the last complete level, reduced to a few
//   respond     impulses; never add energy
//
// A step is a pure function of the state, the input and the work granted: it reads no clock and
// no file, and gives the same bits on every machine. (Dingliana 2002, ch. 3)
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "engine/dynamics/body.hpp"
#include "engine/dynamics/finite_states.hpp"
#include "engine/figures/figures.hpp"
#include "engine/scheduling/priority_memory.hpp"
#include "engine/scheduling/work_meter.hpp"
#include "engine/world/impositions.hpp"
#include "engine/world/step.hpp"
#include "engine/world/step_memory.hpp"
#include "engine/world/value_pointer.hpp"
#include "engine/world/world_settings.hpp"

namespace impetus::inline world {

/// Raised whenever a recording made before may no longer replay.
inline constexpr int kRecordingFormat = 2;

/// Older recordings are tried, and their hashes tell whether they replay. Those of format 1 do,
/// unless a body turned far in a step (dynamics/motion.hpp) or had a heterogeneous tree.
inline constexpr int kOldestRecordingFormat = 1;

/// What a world remembers of two bodies, or of a body and a wall, that touched in a step.
struct TouchingPair {
  BodyPair bodies;
  Vector3 normal{Vector3::UnitX()};  ///< of their deepest contact
};

class World {
 public:
  /// `states` are the bodies' states at time zero, one per model. Throws std::invalid_argument on
  /// an unequal number, a body or state that it cannot step (world_checks.hpp), or settings out of
  /// range.
  World(std::vector<BodyModel> models, std::vector<BodyState> states, WorldSettings settings);

  /// What it returns stays until the next step, and as long as the world does. Throws
  /// std::invalid_argument unless `input.dt_s` is a finite number, 0 or more.
  const StepReport& step(const StepInput& input, WorkMeter& meter);

  [[nodiscard]] const std::vector<BodyModel>& models() const { return models_; }
  [[nodiscard]] const std::vector<BodyState>& states() const { return states_; }
  [[nodiscard]] const WorldSettings& settings() const { return settings_; }

  /// Another schedule from the next step on. Throws std::invalid_argument when it is out of range.
  void set_schedule(Schedule schedule);

  /// The same of how contacts are reduced, of fast bodies, of the response, of rotation and of what
  /// work costs.
  void set_contacts(ContactModel contacts);
  void set_tunnelling(Tunnelling tunnelling) { settings_.tunnelling = tunnelling; }
  void set_response(ResponseMethod response);
  void set_rotation(Rotation rotation) { settings_.rotation = rotation; }
  void set_costs(const WorkCosts& costs);

  /// Whether steps report the contacts of all overlapping nodes, for drawing: changes nothing else.
  void watch_node_contacts(bool watch) { watches_node_contacts_ = watch; }

  /// How many nodes of the bodies' trees all steps so far have transformed into the world.
  [[nodiscard]] std::int64_t nodes_transformed() const;

  /// For tests that ask whether a changed start is noticed.
  [[nodiscard]] std::vector<BodyState>& mutable_states() { return states_; }

 private:
  void move_and_pair(double dt_s);
  void find_falls(double dt_s);
  void stop_fast_pairs(double dt_s);
  void add_wall_candidates();
  void model_folds();
  [[nodiscard]] std::int64_t folds_work() const;
  [[nodiscard]] bool is_of_figure(BodyPair bodies) const {
    return figures_ && figures_->has_part(bodies);
  }
  void note_not_finite();
  [[nodiscard]] bool is_capped_by_speed(BodyPair bodies) const;
  [[nodiscard]] int level_capped_by_speed(BodyPair bodies, double dt_s, int greatest_level) const;
  [[nodiscard]] Measuring measuring(const StepInput& input) const;
  void prioritise(const StepInput& input);
  void refine(const StepInput& input, WorkMeter& meter);
  void begin_refining(const ScheduledPair& pair, const StepInput& input);
  [[nodiscard]] int walls_in_reach(std::size_t body) const;
  void model(const StepInput& input);
  void add_contacts_of(const RefinedPair& pair);
  void count_later_phases();
  [[nodiscard]] MovingTree moving(std::size_t body);
  void respond(double dt_s);
  const ResponseResult& response_to_contacts(double dt_s);
  void note_touching(const Viewer& viewer);
  [[nodiscard]] const TouchingPair* touched_before(BodyPair bodies) const;
  void change_settings(WorldSettings changed);

  std::vector<BodyModel> models_;
  std::vector<BodyState> states_;
  FiniteStates finite_{states_};
  std::vector<PlacedTree> placed_;
  WorldSettings settings_;
  ValuePointer<Figures> figures_;  ///< none: nothing
  SweepAndPrune broad_phase_;
  bool watches_node_contacts_{false};
  std::vector<TouchingPair> touching_;  ///< in contact after the last step, sorted by bodies
  PriorityMemory priorities_;
  LevelMemory levels_;
  Impositions impositions_;
  StepMemory memory_;
};

}  // namespace impetus::inline world
