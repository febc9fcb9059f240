// What holds for every body of a world, and for every step.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/collision/contact_reduction.hpp"
#include "engine/collision/entry/time_of_entry.hpp"
#include "engine/dynamics/impulse.hpp"
#include "engine/dynamics/motion.hpp"
#include "engine/dynamics/restitution.hpp"
#include "engine/figures/figure.hpp"
#include "engine/scheduling/priority_lists.hpp"
#include "engine/scheduling/work_costs.hpp"
#include "engine/scheduling/work_meter.hpp"
#include "engine/volumes/enclosure.hpp"

namespace impetus::inline world {

/// Changes of angular velocity that are imposed on two bodies when they collide: added to those of
/// both (rad/s, world). This is not physics. Linear momentum and its energy stay what the response
/// made them. Angular momentum is not kept, about any point, and rotational energy is whatever the
/// new spin has. (Dingliana 2002, sec. 6.2.2: at the lowest level bodies are spheres, whose
/// collisions turn nothing)
struct ImposedSpin {
  Vector3 a{Vector3::Zero()};
  Vector3 b{Vector3::Zero()};
};

/// When it is imposed: at the first contact that bodies 0 and 1 of the world respond to, if that
/// was found at this level; once in a world's life.
struct ImposedSpinRule {
  int at_level{0};
  ImposedSpin spin;
};

/// Velocities that are imposed on bodies 0 and 1 of the world after the first contact that they
/// respond to; once in a world's life. This is not physics: neither momentum nor energy is kept.
/// What turns goes on turning. (O'Sullivan, Dingliana, Giang and Kaiser 2003, angular and momentum
/// distortions)
struct ImposedRebound {
  /// What the angle between their ways gains, half of it from each; below 0: what it loses.
  double wider_deg{0.0};
  /// Across the plane in which it is measured, and in which they are turned: a unit vector.
  Vector3 axis{Vector3::UnitZ()};
  double speed_ratio{1.0};  ///< of both speeds, to those of the response
};

/// Raised whenever a recording made before may no longer replay by the rules of now.
inline constexpr int kRecordingFormat = 9;

/// Older recordings are tried, and their hashes tell whether they replay. From format 2 on they do,
/// for their worlds go by its rules (WorldSettings::recording_format). So do those of format 1,
/// unless a body turned far in a step (dynamics/motion.hpp) or had a heterogeneous tree.
inline constexpr int kOldestRecordingFormat = 1;

inline constexpr bool is_tried(int recording_format) {
  return kOldestRecordingFormat <= recording_format && recording_format <= kRecordingFormat;
}

/// As it stands: elastic bodies without walls, all refined to the finest level, nearest first.
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
  /// Of every body that can move (motion.hpp); where there is any, approaches slower than it gives
  /// a body in kRestingSteps steps are given nothing back.
  Vector3 gravity_m_s2{Vector3::Zero()};
  /// Over the contacts of an island, in a step; what still approaches is left to the next step
  /// (ResponseRules::most_passes).
  int most_response_passes{kUnlimitedPasses};
  /// Of node pairs along the ways of fast bodies (Tunnelling::kStopAtEntry), in a step: they are
  /// part of the floor of a budget in work; one in time limits them, too. Never more; fast pairs
  /// for which none are left are refined as if capped.
  std::int64_t most_entry_tests{kUnlimitedTests};
  std::optional<ImposedSpinRule> imposed_spin{};    ///< an imposed manipulation, not physics
  std::optional<ImposedRebound> imposed_rebound{};  ///< an imposed manipulation, not physics
  /// Bodies that hinges join, in the order of their bodies.
  std::vector<Figure> figures{};
  /// By whose rules the world steps: an older one's, where a recording of it is replayed. Before 3
  /// whatever touches a body keeps it from falling, walls push where they touch alone, and what the
  /// hinges of a figure hold is pushed, too. Before 4 figures that lie sink (Fall::comes_last).
  /// Before 5 centres go through walls and are turned back behind them (centres_at_walls.hpp).
  /// Before 6 the hinges of figures whose motion is cut are left open, and torn where a part is
  /// brought back from beyond a wall (as_one_body.hpp). Before 8 searches for entries foresee the
  /// ways of nodes less exactly, and take more tests, before 7 yet more (EntryRules). Before 9 a
  /// pair for which no work is left costs a test of its roots: as the pair does that was refined in
  /// its place in an earlier step, so that a copy of a world, which knows none, goes another way.
  int recording_format{kRecordingFormat};

  /// Whether what came with a format is not yet so.
  [[nodiscard]] bool has_rules_before(int format) const { return recording_format < format; }
};

/// What is wrong with the settings, as a sentence; empty when nothing is.
std::string problem_of(const WorldSettings& settings);

}  // namespace impetus::inline world
