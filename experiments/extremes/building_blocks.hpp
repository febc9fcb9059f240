// Scenes and figures that several families share.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "experiments/extremes/course.hpp"
#include "experiments/extremes/extreme_scene.hpp"

namespace impetus::inline extremes {

/// The step of the cases that are about something else.
inline constexpr double kStep_s = 1.0 / 240.0;

/// Of 1,000 kg/m³.
double water_mass_kg(const Solid& solid);

/// As short as it can be said, such as "1e-06".
std::string short_number(double number);

ExtremeBody ball(double radius_m, const Vector3& place_m = Vector3::Zero(),
                 const Vector3& velocity_m_s = Vector3::Zero());
ExtremeBody block(const Vector3& edges_m, const Vector3& place_m = Vector3::Zero(),
                  const Vector3& velocity_m_s = Vector3::Zero());

/// Two balls alike that meet head on along x, each at `speed_m_s`, in the middle of the eleventh
/// step; then as many steps again.
ExtremeScene head_on(double radius_m, double speed_m_s, double step_s);

/// The kinds of volume tree, in their order.
std::vector<TreeKind> all_tree_kinds();

/// | u' / u + e |: how far the speed at which bodies 0 and 1 part along x is from restitution times
/// the speed at which they met, as a share of that.
double rebound_error(const Course& course);

/// What the most energy that there was exceeds that at the start by, as its share.
double energy_gain(const Course& course);

/// What the most and the least are apart, as a share of the start's.
double energy_swing(const Course& course);

/// As a share of the sizes of all momenta at the start.
double momentum_drift(const Course& course);

/// How far the length of any orientation was from one.
double unit_length_lost(const Course& course);

/// That any body's centre went from where it was, at most (m); infinite unless all was finite.
double distance_gone_m(const Course& course);

/// energy_gain(), but infinite unless bodies touched and all numbers were finite.
double energy_gain_by_touching(const Course& course);

/// Blocks in trees of `kind` at random places and orientations, flying at about 1 m/s, spinning at
/// about 5 rad/s; their bounding balls would fill `filled` of the cube. The same for the same
/// arguments.
ExtremeScene crowd_scene(int count, double filled, double restitution, std::int64_t steps,
                         TreeKind kind = TreeKind::kBox);

}  // namespace impetus::inline extremes
