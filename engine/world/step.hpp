// What goes into a step and what comes out of it.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "engine/collision/contact_model.hpp"
#include "engine/collision/entry/time_of_entry.hpp"
#include "engine/collision/pair_refinement.hpp"
#include "engine/dynamics/finite_states.hpp"
#include "engine/dynamics/state_hash.hpp"
#include "engine/scheduling/priority_lists.hpp"
#include "engine/scheduling/work_meter.hpp"

namespace impetus::inline world {

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
  kNotFinite = 4,        ///< a body is out, since its state was not a finite number
  kStoppedShort = 8,     ///< bodies were stopped at entry and lost the rest of the step
  /// WorldSettings::most_entry_tests, or the meter, kept fast pairs from being tested along their
  /// whole way: they stayed at coarser levels, or stopped early
  kEntryTestsSpent = 16,
  kMotionCut = 32,  ///< figures took the step in fewer parts than they should, or as one body
  kPairsLeft = 64,  ///< pairs of bodies were not found, or hardly reach into each other and were
                    ///< not looked at
  kContactsLeft = 128,  ///< pairs that touch got no contact
  kResponseCut = 256,   ///< contacts were not answered until nothing approaches
};

/// Their names, by bit.
inline constexpr std::array<std::string_view, 9> kDegradationNames{
    "floor over budget", "approach remains", "not finite",    "stopped short", "entry search cut",
    "motion cut",        "pairs left",       "contacts left", "response cut"};

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
  bool imposed_spin{false};          ///< this contact got WorldSettings::imposed_spin
  std::optional<double> measured{};  ///< by the schedule's metric, in its unit; none without one
};

/// A pop: a pair that touches at a coarser level than in the step before. Bounds that grow at once
/// push bodies apart that did not move; bounds that shrink are rarely noticed. (Dingliana 2002,
/// sec. 5.3.1)
struct LevelPop {
  BodyPair bodies;
  int from{0};
  int to{0};
  double size_deg{0.0};  ///< visual angle of what its bounds grew by
};

/// All that a step tells of itself.
struct StepReport {
  std::vector<CollisionReport> collisions;
  std::int64_t work_granted{0};  ///< units of work (WorldSettings::costs); a replay grants the same
  /// What phases were granted that were refused something; beside `work_granted`, what a replay
  /// needs (grants_of()).
  WorkGrants grants{};
  std::int64_t pairs_left{0};     ///< of bodies, that were found and not looked at
  std::int64_t contacts_left{0};  ///< pairs that touch and got no contact
  std::int64_t work_spent{0};     ///< on all phases, at most what was reserved for the later ones
  std::int64_t work_floor{0};     ///< what is done, and what follows it, whatever the budget
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
  /// Bodies that were taken out in this step, for good, because their state was not finite.
  std::vector<NotFiniteBody> not_finite;
};

/// What replays the step that is reported, given to FixedWork.
inline WorkGrants grants_of(const StepReport& report) {
  WorkGrants grants = report.grants;
  grants.of(WorkPhase::kRefinement) = report.work_granted;
  return grants;
}

}  // namespace impetus::inline world
