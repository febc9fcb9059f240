// An articulated figure: bodies that are its parts, joined by hinges into a tree.
//
//   transform hierarchy    root part <- hinges <- parts: where the parts are
//   collision hierarchy    top bound of all poses -> parts -> the nodes of each part's own tree
//
// The parts are bodies like any other: paired, scheduled, refined, recorded and hashed as such. A
// figure moves freely, its hinges kept by impulses, or is driven by a joint motion that nothing
// disturbs. (Dingliana 2002, sec. 4.1.3)
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/figures/hinge.hpp"
#include "engine/figures/joint_motion.hpp"

namespace impetus::inline figures {

/// Which parts of one figure may collide with each other.
struct SelfCollision {
  bool others{true};      ///< parts that no hinge joins, as a soup of bodies
  bool neighbours{true};  ///< parts that one joins, by the fold of their cores (Hinge::fold_rad)
};

/// Its parts, the hinges that join them, and what moves it.
struct Figure {
  std::string name;
  std::int32_t first_part{0};  ///< the root: a body's index
  std::int32_t part_count{1};  ///< its parts are that body and those after it
  /// hinges[i].child is part i + 1, hinges[i].parent an earlier part.
  std::vector<Hinge> hinges;
  SelfCollision self_collision{};
  std::optional<JointMotion> driven{};  ///< none: it moves freely

  [[nodiscard]] bool has_part(std::int32_t body) const {
    return body >= first_part && body < first_part + part_count;
  }
};

/// The poses of all parts, root first, with the root so placed and the hinges at these angles.
/// Throws std::invalid_argument where a hinge joins no earlier part or lacks an angle.
std::vector<Pose> poses_of(const Figure& figure, const Pose& root,
                           const std::vector<double>& angles_rad);

/// The same, instead of what `poses` held.
void find_poses(const Figure& figure, const Pose& root, const std::vector<double>& angles_rad,
                std::vector<Pose>& poses);

/// The angle of each hinge at rest (radians).
std::vector<double> rest_angles(const Figure& figure);

/// The states of a free figure so posed that moves as one rigid body: `velocity_m_s` is that of its
/// root's centre of mass, `spin_rad_s` its turn in the world. `models` are all bodies of the world.
std::vector<BodyState> states_of(const Figure& figure, const std::vector<BodyModel>& models,
                                 const std::vector<Pose>& poses, const Vector3& velocity_m_s,
                                 const Vector3& spin_rad_s);

/// The states of a driven figure's parts at `time_s`, with the momenta of its motion over the
/// `dt_s` seconds before (at time 0, after).
std::vector<BodyState> driven_states(const Figure& figure, const std::vector<BodyModel>& models,
                                     double time_s, double dt_s);

/// Makes the same of `states`, which are all bodies', in memory that it keeps.
class DrivenMotion {
 public:
  void drive(const Figure& figure, const std::vector<BodyModel>& models, double time_s, double dt_s,
             std::vector<BodyState>& states);

 private:
  void find_poses_at(const Figure& figure, double time_s, std::vector<Pose>& poses);

  std::vector<double> angles_rad_;
  std::vector<Pose> poses_;
  std::vector<Pose> others_;
};

/// Radius about the root's centre of mass within which every part stays at all angles within the
/// hinges' limits, by the bounds of the parts' trees (metres).
double top_bound_m(const Figure& figure, const std::vector<BodyModel>& models);

/// What is wrong with a figure of these bodies, as a sentence that names it; empty when nothing is.
std::string problem_of(const Figure& figure, const std::vector<BodyModel>& models);

/// The same of all figures of a world, no two of which share a part, and of where they are: the
/// parts of one that moves freely begin at their hinges. `states` are those of all bodies, and
/// finite.
std::string problem_of(const std::vector<Figure>& figures, const std::vector<BodyModel>& models,
                       const std::vector<BodyState>& states);

}  // namespace impetus::inline figures
