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

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/collision/contact_model.hpp"
#include "engine/collision/contact_reduction.hpp"
#include "engine/collision/list_refinement.hpp"
#include "engine/collision/sweep_and_prune.hpp"
#include "engine/collision/tunnelling.hpp"
#include "engine/dynamics/body.hpp"
#include "engine/dynamics/impulse.hpp"
#include "engine/dynamics/motion.hpp"
#include "engine/dynamics/restitution.hpp"
#include "engine/dynamics/state_hash.hpp"
#include "engine/level_pops.hpp"
#include "engine/scheduling/priority_lists.hpp"
#include "engine/scheduling/priority_memory.hpp"
#include "engine/scheduling/work_costs.hpp"
#include "engine/scheduling/work_meter.hpp"
#include "engine/volumes/enclosure.hpp"

namespace impetus {

/// Raised whenever a recording made before would no longer replay.
inline constexpr int kRecordingFormat = 1;

/// How the impulses of contacts that affect each other are found: one after the other, or for all
/// of an island together, after which nothing approaches (see simultaneous_response.hpp).
enum class ResponseMethod { kInTurn, kTogether };

/// What holds for every body of the world.
struct WorldSettings {
  double restitution{1.0};  ///< in [0, 1]
  /// An imposed manipulation, not physics: bodies stay where they touched for this long before
  /// their rebound shows (Dingliana 2002, sec. 6.2.1).
  double imposed_hold_s{0.0};
  std::optional<Enclosure> enclosure{};  ///< walls that keep the bodies inside
  Schedule schedule{};
  ResponseMethod response{ResponseMethod::kInTurn};
  ContactModel contacts{};
  Tunnelling tunnelling{Tunnelling::kStopAtEntry};
  WorkCosts costs{};
  /// Restitutions of pairs of materials (BodyModel::material) that differ from `restitution`.
  std::vector<PairRestitution> materials{};
  int wall_material{0};
  Rotation rotation{Rotation::kMidpoint};
};

/// Everything that decides a step besides the state.
struct StepInput {
  double dt_s{0.0};
  Viewer viewer;
  Fixation fixation{};                 ///< the screen's centre when there is none
  std::optional<GazeRegion> region{};  ///< for schedules whose lists follow a region
};

/// What kept a step from being what it should, as bits.
enum Degradation : std::uint32_t {
  kFloorOverBudget = 1,  ///< the coarsest level of every pair cost more than was granted
  kApproachRemains = 2,  ///< the response ran out of passes and left bodies approaching
  kNotFinite = 4,        ///< a state is not a finite number
  kStoppedShort = 8,     ///< bodies were stopped at entry and lost the rest of the step
};

/// A contact that the response got.
struct ReportedContact {
  TouchPoint touch;
  double approach_m_s{0.0};  ///< speed of approach along the normal, before the response
  double impulse_Ns{0.0};    ///< along the normal
};

/// One pair of bodies that is in contact at the end of the step.
struct CollisionReport {
  BodyPair bodies;                       ///< b is a wall when is_wall(b)
  int list{0};                           ///< priority list it was refined in
  int level{0};                          ///< last complete level of refinement
  StopReason stop{StopReason::kFinest};  ///< why it went no deeper
  Contact contact;                       ///< the only one; of several, the deepest
  bool began{false};                     ///< the pair was apart in the step before
  double approach_m_s{0.0};              ///< the fastest of its contacts'
  double impulse_Ns{0.0};                ///< sum over its contacts
  double imposed_hold_s{0.0};            ///< the hold that this contact started
  std::int32_t first_contact{0};  ///< its contacts in StepReport::contacts: this and those after it
  std::int32_t contact_count{1};
};

struct StepReport {
  std::vector<CollisionReport> collisions;
  std::int64_t work_granted{0};  ///< units of work (WorldSettings::costs); a replay grants the same
  std::int64_t work_spent{0};    ///< on all phases, at most what was reserved for the later ones
  std::int64_t work_floor{0};    ///< what is done, and what follows it, whatever the budget
  /// Units beyond the floor that each priority list spent on tests; empty when there is one list.
  std::vector<std::int64_t> list_work;
  std::uint32_t degradations{0};
  StateHash state;
  std::vector<ReportedContact> contacts;  ///< of all collisions, in their order
  std::vector<LevelPop> pops;
  std::vector<StoppedAtEntry> stopped;
  /// Contacts of all overlapping nodes, before reduction; only when they are watched.
  std::vector<Contact> node_contacts;
  /// For modelling and response, when refinement ended.
  std::int64_t work_reserved{0};
  /// The most that was spent and reserved at any time: at most what was granted, or the floor.
  std::int64_t work_peak{0};
};

/// What a world remembers of two bodies, or of a body and a wall, that touched in a step.
struct TouchingPair {
  BodyPair bodies;
  Vector3 normal{Vector3::UnitX()};  ///< of their deepest contact
};

class World {
 public:
  /// `states` are the bodies' states at time zero, one per model. Throws std::invalid_argument on
  /// an unequal number, a body without a tree, or settings out of range.
  World(std::vector<BodyModel> models, std::vector<BodyState> states, WorldSettings settings);

  StepReport step(const StepInput& input, WorkMeter& meter);

  [[nodiscard]] const std::vector<BodyModel>& models() const { return models_; }
  [[nodiscard]] const std::vector<BodyState>& states() const { return states_; }
  [[nodiscard]] const WorldSettings& settings() const { return settings_; }

  /// Another schedule from the next step on. Throws std::invalid_argument when it is out of range.
  void set_schedule(Schedule schedule);

  /// The same of how contacts are reduced, of fast bodies, of the response, of rotation and of what
  /// work costs.
  void set_contacts(ContactModel contacts);
  void set_tunnelling(Tunnelling tunnelling) { settings_.tunnelling = tunnelling; }
  void set_response(ResponseMethod response) { settings_.response = response; }
  void set_rotation(Rotation rotation) { settings_.rotation = rotation; }
  void set_costs(const WorkCosts& costs);

  /// Whether steps report the contacts of all overlapping nodes, for drawing: changes nothing else.
  void watch_node_contacts(bool watch) { watches_node_contacts_ = watch; }

  /// For tests that ask whether a changed start is noticed.
  [[nodiscard]] std::vector<BodyState>& mutable_states() { return states_; }

 private:
  std::vector<PairBounds> move_and_pair(double dt_s, StepReport& report);
  void stop_fast_pairs(const std::vector<BodyState>& before, double dt_s,
                       std::vector<PairBounds>& candidates, StepReport& report);
  void add_wall_candidates(const std::vector<MovedBound>& bounds,
                           std::vector<PairBounds>& candidates) const;
  void measure_motion_and_fit(PairBounds& pair) const;
  [[nodiscard]] int level_capped_by_speed(BodyPair bodies, double dt_s, int greatest_level) const;
  std::vector<ScheduledPair> prioritise(const std::vector<PairBounds>& candidates,
                                        const StepInput& input);
  std::vector<RefinedPair> refine(const std::vector<ScheduledPair>& order, const StepInput& input,
                                  WorkMeter& meter, StepReport& report);
  RefinedPair begin_refining(const ScheduledPair& pair, const StepInput& input);
  [[nodiscard]] int walls_in_reach(std::size_t body) const;
  void count_later_phases(const std::vector<RefinedPair>& refined, StepReport& report) const;
  void note_touching(const Viewer& viewer, StepReport& report);
  std::vector<Contact> contacts_of(const RefinedPair& pair, std::vector<Contact>* watched);
  [[nodiscard]] MovingTree moving(std::size_t body);
  void model(const std::vector<RefinedPair>& refined, StepReport& report);
  ResponseResult response_to(const std::vector<Contact>& contacts);
  void respond_to(StepReport& report);
  [[nodiscard]] const TouchingPair* touched_before(BodyPair bodies) const;

  std::vector<BodyModel> models_;
  std::vector<BodyState> states_;
  std::vector<PlacedTree> placed_;
  WorldSettings settings_;
  SweepAndPrune broad_phase_;
  bool watches_node_contacts_{false};
  std::vector<TouchingPair> touching_;  ///< pairs in contact after the last step
  PriorityMemory priorities_;
  LevelMemory levels_;
};

}  // namespace impetus
