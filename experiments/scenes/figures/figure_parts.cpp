// SPDX-License-Identifier: MIT
#include "experiments/scenes/figures/figure_parts.hpp"

#include <algorithm>
#include <cmath>

#include "engine/numerics/elementary_functions.hpp"
#include "experiments/scenes/swept_shape.hpp"

namespace impetus::inline scenes {
namespace {

using nlohmann::json;

Vector3 vector_from(const json& numbers) {
  return {numbers[0].get<double>(), numbers[1].get<double>(), numbers[2].get<double>()};
}

/// Unit and across `axis`, by the axis of the frame that lies most across it.
Vector3 across(const Vector3& axis) {
  int least = 0;
  for (int i = 1; i < 3; ++i) {
    least = std::abs(axis[i]) < std::abs(axis[least]) ? i : least;
  }
  return axis.cross(Vector3::Unit(least)).normalized();
}

/// The given direction, or from the anchor to the centre.
Vector3 core_of(const json& hinge, const char* key, const Vector3& anchor) {
  return (hinge.contains(key) ? vector_from(hinge[key]) : Vector3(-anchor)).normalized();
}

HingeSide side_of(const json& hinge, const char* anchor_key, const char* core_key,
                  double height_m) {
  const Vector3 anchor = vector_from(hinge[anchor_key]);
  HingeSide side;
  side.anchor = height_m * anchor;
  side.axis = vector_from(hinge["axis"]).normalized();
  side.zero = across(side.axis);
  side.core = core_of(hinge, core_key, anchor);
  return side;
}

}  // namespace

json part_shape(const json& part, double height_deg, const std::string& coarsest) {
  const std::string suffix = "_share";
  json shape = json::object();
  const json& shares = part["shape"];
  for (auto entry = shares.begin(); entry != shares.end(); ++entry) {
    const std::string& key = entry.key();
    if (key.ends_with(suffix)) {
      const std::string name = key.substr(0, key.size() - suffix.size()) + "_deg";
      shape[name] = height_deg * entry.value().get<double>();
    } else {
      shape[key] = entry.value();
    }
  }
  if (is_swept(shape)) {
    if (part.contains("tree")) {
      shape["deeper"] = true;
    }
    if (!coarsest.empty() && !shape.contains("coarsest")) {
      shape["coarsest"] = coarsest;
    }
  }
  return shape;
}

TreeSettings part_tree(const json& part, TreeSettings engine) {
  if (!part.contains("tree")) {
    return engine;
  }
  const json& tree = part["tree"];
  TreeSettings settings;
  settings.kind = tree_kind(tree["kind"].get<std::string>());
  settings.depth = std::min(engine.depth, tree.value("depth", engine.depth));
  settings.branching = tree.value("branching", settings.branching);
  settings.built_depth = engine.built_depth;
  return settings;
}

Hinge part_hinge(const json& figure, std::size_t index, std::int32_t root, double height_m) {
  const json& entry = figure["parts"][index]["hinge"];
  Hinge hinge;
  hinge.child = root + static_cast<std::int32_t>(index);
  hinge.parent =
      root + static_cast<std::int32_t>(part_named(figure, entry["parent"].get<std::string>()));
  hinge.of_child = side_of(entry, "on_part", "core_of_part", height_m);
  hinge.of_parent = side_of(entry, "on_parent", "core_of_parent", height_m);
  const auto angle = [&](const char* key, double otherwise_rad) {
    return entry.contains(key) ? entry[key].get<double>() * kRadiansPerDegree : otherwise_rad;
  };
  hinge.rest_rad = angle("rest_deg", hinge.rest_rad);
  hinge.least_rad = angle("least_deg", hinge.least_rad);
  hinge.most_rad = angle("most_deg", hinge.most_rad);
  hinge.fold_rad = angle("fold_deg", hinge.fold_rad);
  return hinge;
}

std::size_t joint_named(const json& figure, const std::string& name) {
  const json& parts = figure["parts"];
  std::size_t joint = 0;
  while (joint + 1 < parts.size() &&
         parts[joint + 1]["hinge"]["name"].get_ref<const std::string&>() != name) {
    ++joint;
  }
  return joint;
}

std::vector<double> joint_angles(const json& figure, const json& angles_deg) {
  std::vector<double> angles;
  for (std::size_t part = 1; part < figure["parts"].size(); ++part) {
    const json& hinge = figure["parts"][part]["hinge"];
    const auto name = hinge["name"].get<std::string>();
    const double rest_deg = hinge.value("rest_deg", 0.0);
    angles.push_back(kRadiansPerDegree * angles_deg.value(name, rest_deg));
  }
  return angles;
}

std::size_t part_named(const json& figure, const std::string& name) {
  const json& parts = figure["parts"];
  std::size_t part = 0;
  while (part < parts.size() && parts[part]["name"].get_ref<const std::string&>() != name) {
    ++part;
  }
  return part;
}

}  // namespace impetus::inline scenes
