// SPDX-License-Identifier: MIT
#include "experiments/scenes/figures/figure_making.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "engine/numerics/elementary_functions.hpp"

namespace impetus::inline scenes {
namespace {

/// Unit and across `axis`, by the axis of the frame that lies most across it.
Vector3 across(const Vector3& axis) {
  int least = 0;
  for (int i = 1; i < 3; ++i) {
    least = std::abs(axis[i]) < std::abs(axis[least]) ? i : least;
  }
  return axis.cross(Vector3::Unit(least)).normalized();
}

/// `core` is the given direction; else it goes from the anchor to the centre.
HingeSide hinge_side(const Vector3& axis, const Vector3& anchor, const std::optional<Vector3>& core,
                     double height_m) {
  HingeSide side;
  side.anchor = height_m * anchor;
  side.axis = axis.normalized();
  side.zero = across(side.axis);
  side.core = core.value_or(-anchor).normalized();
  return side;
}

std::vector<JointWave> waves_of(const FigureSettings& figure, const MotionSettings& motion,
                                const std::vector<double>& angles_rad) {
  std::vector<JointWave> waves;
  waves.reserve(angles_rad.size());
  for (const double angle_rad : angles_rad) {
    waves.push_back({angle_rad, 0.0});
  }
  if (motion.waves) {
    for (const auto& [joint, wave] : *motion.waves) {
      waves[figure.joint_named(joint)] = {wave.middle_deg * kRadiansPerDegree,
                                          wave.amplitude_deg * kRadiansPerDegree, wave.phase,
                                          wave.cycles};
    }
  }
  return waves;
}

std::vector<JointKey> keys_of(const FigureSettings& figure, const MotionSettings& motion,
                              const std::vector<double>& angles_rad) {
  std::vector<JointKey> keys;
  for (const KeySettings& entry : motion.keys.value_or(std::vector<KeySettings>{})) {
    JointKey key{entry.time_s, angles_rad};
    for (const auto& [joint, angle_deg] : entry.angles_deg) {
      key.angles_rad[figure.joint_named(joint)] = angle_deg * kRadiansPerDegree;
    }
    keys.push_back(std::move(key));
  }
  return keys;
}

}  // namespace

ShapeSettings part_shape(const PartSettings& part, double height,
                         std::optional<bool> sphere_first) {
  ShapeSettings shape = scaled(part.shape, height);
  if (shape.is_swept()) {
    if (part.tree) {
      shape.deeper = true;
    }
    if (!shape.sphere_first) {
      shape.sphere_first = sphere_first;
    }
  }
  return shape;
}

TreeSettings part_tree(const PartSettings& part, TreeSettings engine) {
  if (!part.tree) {
    return engine;
  }
  return {part.tree->kind, std::min(engine.depth, part.tree->depth.value_or(engine.depth)),
          part.tree->branching, engine.built_depth};
}

Hinge part_hinge(const FigureSettings& figure, std::size_t index, std::int32_t root,
                 double height_m) {
  const HingeSettings& entry = *figure.parts[index].hinge;
  Hinge hinge;
  hinge.child = root + static_cast<std::int32_t>(index);
  hinge.parent = root + static_cast<std::int32_t>(figure.part_named(entry.parent));
  hinge.of_child = hinge_side(entry.axis, entry.on_part, entry.core_of_part, height_m);
  hinge.of_parent = hinge_side(entry.axis, entry.on_parent, entry.core_of_parent, height_m);
  const auto angle = [](const std::optional<double>& angle_deg, double otherwise_rad) {
    return angle_deg ? *angle_deg * kRadiansPerDegree : otherwise_rad;
  };
  hinge.rest_rad = entry.rest_deg * kRadiansPerDegree;
  hinge.least_rad = angle(entry.least_deg, hinge.least_rad);
  hinge.most_rad = angle(entry.most_deg, hinge.most_rad);
  hinge.fold_rad = angle(entry.fold_deg, hinge.fold_rad);
  return hinge;
}

std::vector<double> joint_angles(const FigureSettings& figure, const AnglesByJoint& angles_deg) {
  std::vector<double> angles;
  for (std::size_t part = 1; part < figure.parts.size(); ++part) {
    const HingeSettings& hinge = *figure.parts[part].hinge;
    const auto stated = angles_deg.find(hinge.name);
    angles.push_back(kRadiansPerDegree *
                     (stated == angles_deg.end() ? hinge.rest_deg : stated->second));
  }
  return angles;
}

JointMotion joint_motion(const FigureSettings& figure, const MotionSettings& motion,
                         double height_m, const std::vector<double>& angles_rad) {
  JointMotion made;
  made.root.bob_m = height_m * motion.bob_share.value_or(Vector3(Vector3::Zero()));
  made.root.spin_rad_s = kRadiansPerDegree * motion.root_spin_deg_s;
  made.period_s = motion.period_s.value_or(made.period_s);
  made.waves = waves_of(figure, motion, angles_rad);
  made.keys = keys_of(figure, motion, angles_rad);
  made.repeats = motion.repeats.value_or(false);
  return made;
}

std::vector<std::string> joints_of(const MotionSettings& motion) {
  std::set<std::string> names;
  if (motion.waves) {
    for (const auto& [joint, wave] : *motion.waves) {
      names.insert(joint);
    }
  }
  for (const KeySettings& key : motion.keys.value_or(std::vector<KeySettings>{})) {
    for (const auto& [joint, angle_deg] : key.angles_deg) {
      names.insert(joint);
    }
  }
  return {names.begin(), names.end()};
}

}  // namespace impetus::inline scenes
