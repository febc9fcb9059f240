// What a figure file says, as structs: rigid parts, the hinges between them, and named motions.
//
// A scene holds the figures that it names by content ("figure_files"), so that a recording holds
// all that a replay needs, and a factor may change any value of a figure by its JSON Pointer.
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "engine/figures/joint_motion.hpp"
#include "engine/trees/tree_settings.hpp"
#include "experiments/scenes/shape_settings.hpp"

namespace impetus::inline scenes {

/// By which a part hangs from another. Points are shares of the figure's height.
struct HingeSettings {
  std::string name;
  std::string parent;
  Vector3 on_parent{Vector3::Zero()};
  Vector3 on_part{Vector3::Zero()};
  Vector3 axis{Vector3::Zero()};
  double rest_deg{0.0};
  std::optional<double> least_deg;
  std::optional<double> most_deg;
  std::optional<double> fold_deg;
  std::optional<Vector3> core_of_parent;
  std::optional<Vector3> core_of_part;
};

/// A part's own kind of volume tree.
struct PartTree {
  TreeKind kind{TreeKind::kOctree};
  std::optional<int> depth;
  int branching{TreeSettings{}.branching};
};

/// A part of a figure, as the figure's file says.
struct PartSettings {
  std::string name;
  ShapeSettings shape;  ///< in shares of the figure's height
  std::size_t colour{0};
  std::optional<PartTree> tree;
  std::optional<HingeSettings> hinge;
};

/// How a joint swings.
struct WaveSettings {
  double middle_deg{0.0};
  double amplitude_deg{0.0};
  double phase{JointWave{}.phase};
  int cycles{JointWave{}.cycles};
};

using AnglesByJoint = std::map<std::string, double>;  ///< degrees

/// Where joints are at a time.
struct KeySettings {
  double time_s{0.0};
  AnglesByJoint angles_deg;
};

/// Waves or keys.
struct MotionSettings {
  std::optional<double> period_s;
  std::optional<Vector3> bob_share;
  Vector3 root_spin_deg_s{Vector3::Zero()};
  std::optional<std::map<std::string, WaveSettings>> waves;  ///< by joint
  std::optional<std::vector<KeySettings>> keys;
  std::optional<bool> repeats;
};

/// The root first, each other part after the one that it hangs from.
struct FigureSettings {
  std::vector<PartSettings> parts;
  std::optional<std::map<std::string, MotionSettings>> motions;

  /// The number of the part called `name`, or one past the last.
  [[nodiscard]] std::size_t part_named(const std::string& name) const;
  /// By what scenes and motions call the joints: the hinge's number, or one past the last.
  [[nodiscard]] std::size_t joint_named(const std::string& name) const;
};

const Kind<FigureSettings>& figure_kind();

/// The figure's JSON Schema: stimuli/figure.schema.json, as an output of the rows.
OrderedJson figure_file_schema();
/// The same, for validation.
const nlohmann::json& figure_schema();

/// The JSON Pointer to the content that a scene holds of a figure's file, and to one of its parts.
std::string figure_place(const std::string& file);
std::string part_place(const std::string& file, std::size_t part);

}  // namespace impetus::inline scenes
