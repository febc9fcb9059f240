// Two bodies of a scene that meet, as impacts are made of them.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "engine/dynamics/impulse.hpp"
#include "engine/trees/tree_settings.hpp"
#include "experiments/record/staged_scene.hpp"

namespace impetus::inline trade {

/// Bodies of a scene that are alike: of one shape, mass and material.
struct ImpactBody {
  std::string name;  ///< of the shape, such as "creature"
  DrawnBody look;
  BodyModel model;  ///< its tree means nothing
  std::map<TreeKind, std::shared_ptr<const VolumeTree>> trees;
};

/// How two bodies moved when a scene made them meet.
struct MeetingMotion {
  double approach_m_s{0.0};  ///< of the centres against each other, in any direction
  double spin_a_rad_s{0.0};
  double spin_b_rad_s{0.0};
};

/// Two bodies whose impacts are measured, and how a scene makes them meet.
struct ImpactPair {
  ImpactBody a;
  ImpactBody b;
  std::vector<MeetingMotion> motions;  ///< one or more, to draw from
  double restitution{1.0};
  ResponseMethod response{ResponseMethod::kInTurn};
  int most_contacts{4};  ///< of a pair, whatever the reduction leaves
  Viewer viewer;

  [[nodiscard]] std::string name() const { return a.name + " x " + b.name; }

  /// The diameter of the smaller body's ball about its centre of mass: what sizes are shares of.
  [[nodiscard]] double size_m() const { return 2.0 * std::min(a.look.radius_m, b.look.radius_m); }
};

}  // namespace impetus::inline trade
