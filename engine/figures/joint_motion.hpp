// How the joints of a driven figure move: an angle for each at any time, from sine waves (walk,
// wave) or from recorded keys, while its root goes on a path.
//
// No library trigonometry: the same bits on every machine.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "engine/numerics/vector.hpp"

namespace impetus::inline figures {

/// amplitude · sin(2π (cycles · t / period + phase)), about a middle.
struct JointWave {
  double middle_rad{0.0};
  double amplitude_rad{0.0};
  double phase{0.0};  ///< share of a turn
  int cycles{1};      ///< whole, in a period
};

/// Where the joints are at a moment: an angle for each.
struct JointKey {
  double time_s{0.0};
  std::vector<double> angles_rad;
};

/// Where the root goes: straight at a steady speed, turning steadily about an axis of the world.
struct RootPath {
  Pose start;
  Vector3 velocity_m_s{Vector3::Zero()};
  Vector3 spin_rad_s{Vector3::Zero()};
  Vector3 bob_m{Vector3::Zero()};  ///< it swings by this twice a period, as hips do in a walk
};

/// Waves, one for each joint; or keys, whose times rise from 0, each with an angle for each joint.
/// Between keys angles go smoothly (cubic Hermite by the mean slopes); after the last they go on
/// from the first if the motion repeats, and stay otherwise.
struct JointMotion {
  RootPath root;
  double period_s{1.0};  ///< of waves
  std::vector<JointWave> waves;
  std::vector<JointKey> keys;
  bool repeats{false};  ///< keys alone: their last equals their first
};

/// The angle of a joint at `time_s` (0 or more).
double joint_angle(const JointMotion& motion, std::size_t joint, double time_s);

/// Where the root is at `time_s`.
Pose root_pose(const JointMotion& motion, double time_s);

/// What is wrong with the motion of a figure with so many joints; empty when nothing is.
std::string problem_of(const JointMotion& motion, std::size_t joints);

}  // namespace impetus::inline figures
