// One collision of a scene as each level of detail has it: where it begins, what touches, what
// comes of it.
//
//   scene at its finest level ──> the first two bodies that collide, while they are still apart
//   those two alone ──level 0──> ... ──level 1──> ... ──finest──> ...      from there, each anew
//
// A coarser level touches earlier, for its volumes reach further. Two bodies come before a body and
// a wall; what is imposed, a hold or a spin, is left out. (Dingliana 2002, figures 6.1 to 6.3)
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "engine/volumes/rounded_box.hpp"
#include "experiments/record/staged_scene.hpp"

namespace impetus::inline run {

/// The bodies of the collision at one moment; one body when it is with a wall.
struct CollisionMoment {
  double time_s{0.0};  ///< of the scene
  std::vector<Pose> poses;
  std::vector<Vector3> velocities;  ///< m/s
};

/// The moments of a collision that are shown: half a body's size before contact, at it, and after
/// it.
enum CollisionMomentName : std::size_t { kBeforeContact, kAtContact, kAfterContact };

/// The scene's first collision as one level of detail handles it.
struct LevelCollision {
  int level{0};
  std::array<CollisionMoment, 3> moments;  ///< by CollisionMomentName
  std::vector<RoundedBox> touching;        ///< nodes in contact, in world
  std::vector<Vector3> node_contacts;      ///< places, before the reduction
  std::vector<TouchPoint> contacts;        ///< after it
  double fit_error_m{0.0};     ///< what the bounds may reach beyond the surfaces, together
  double gap_m{0.0};           ///< between the drawn surfaces at contact
  double gap_arcmin{0.0};      ///< as the viewer sees it
  double normal_off_deg{0.0};  ///< of the deepest contact, from the finest level's
};

/// The same collision at every level, beside each other.
struct CollisionByLevel {
  std::vector<std::size_t> bodies;     ///< of the scene; one when it is with a wall
  std::vector<LevelCollision> levels;  ///< from the root to the finest
};

/// The deepest level of all bodies' trees.
int finest_level_of(const World& world);

/// Throws InputError, in one sentence, when nothing collides within the scene's duration.
CollisionByLevel collision_by_level(const StagedScene& scene);

}  // namespace impetus::inline run
