// Figures for tests: chains and limbs of line-swept parts.
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "engine/world/world.hpp"
#include "tests/engine/builders.hpp"

namespace impetus {

inline constexpr double kPartLength_m = 0.24;  ///< of a part's core
inline constexpr double kPartRadius_m = 0.03;
inline constexpr double kPi = 3.141592653589793;

/// A line-swept part along its own x axis, as heavy as a cylinder of its length.
inline BodyModel swept_part(const std::string& name, double mass_kg = 1.0) {
  BodyModel part;
  part.name = name;
  part.tree = std::make_shared<const VolumeTree>(single_node_tree(
      LineSwept{Vector3::Zero(), Vector3(0.5 * kPartLength_m, 0.0, 0.0), kPartRadius_m}));
  part.inverse_mass = 1.0 / mass_kg;
  const double length_m = kPartLength_m + 2.0 * kPartRadius_m;
  const double across =
      (length_m * length_m / 12.0 + kPartRadius_m * kPartRadius_m / 4.0) * mass_kg;
  const Vector3 inertia(0.5 * kPartRadius_m * kPartRadius_m * mass_kg, across, across);
  part.inverse_inertia = Matrix3(inertia.asDiagonal()).inverse();
  return part;
}

/// Joins the start of one part to the end of another, about an axis across both; straight at 0.
inline Hinge end_to_end(std::int32_t child, std::int32_t parent, const Vector3& axis) {
  const Vector3 along = Vector3::UnitX();
  const Vector3 end(0.5 * kPartLength_m, 0.0, 0.0);
  Hinge hinge;
  hinge.child = child;
  hinge.parent = parent;
  hinge.of_child = {-end, axis, along, along};
  hinge.of_parent = {end, axis, along, -along};
  return hinge;
}

struct FigureScene {
  Figure figure;
  std::vector<BodyModel> models;

  [[nodiscard]] std::vector<BodyState> at_rest(const Pose& root = {}) const {
    return states_of(figure, models, poses_of(figure, root, rest_angles(figure)), Vector3::Zero(),
                     Vector3::Zero());
  }
};

inline void add_part(FigureScene& scene, std::int32_t parent, const Vector3& axis) {
  const auto child = static_cast<std::int32_t>(scene.models.size());
  scene.models.push_back(swept_part("part " + std::to_string(child), 1.0 + 0.1 * (child % 4)));
  scene.figure.part_count = child + 1;
  if (child > 0) {
    scene.figure.hinges.push_back(end_to_end(child, parent, axis));
  }
}

/// Parts in a row whose hinges turn about z and y in turn.
inline FigureScene chain_of(std::int32_t parts, bool about_z_alone = false) {
  FigureScene scene;
  scene.figure.name = "chain";
  for (std::int32_t part = 0; part < parts; ++part) {
    const bool about_z = about_z_alone || part % 2 == 1;
    add_part(scene, part - 1, about_z ? Vector3(Vector3::UnitZ()) : Vector3(Vector3::UnitY()));
  }
  return scene;
}

/// Sixteen parts: each but the last has two that hang from its end, spread by 40 degrees and
/// limited to 60 about that, folded together beyond 80.
inline FigureScene limbs_of_16() {
  FigureScene scene;
  scene.figure.name = "limbs";
  for (std::int32_t part = 0; part < 16; ++part) {
    const bool about_z = part % 4 < 2;
    add_part(scene, (part - 1) / 2,
             about_z ? Vector3(Vector3::UnitZ()) : Vector3(Vector3::UnitY()));
  }
  for (Hinge& hinge : scene.figure.hinges) {
    hinge.rest_rad = (hinge.child % 2 == 1 ? 40.0 : -40.0) / 180.0 * kPi;
    hinge.least_rad = hinge.rest_rad - 60.0 / 180.0 * kPi;
    hinge.most_rad = hinge.rest_rad + 60.0 / 180.0 * kPi;
    hinge.fold_rad = 50.0 / 180.0 * kPi;
  }
  return scene;
}

/// At angles drawn evenly within the limits, or within a half turn where there are none.
inline std::vector<double> random_angles(const Figure& figure, RandomStream& random) {
  std::vector<double> angles;
  for (const Hinge& hinge : figure.hinges) {
    angles.push_back(hinge.is_limited() ? uniform_in(random, hinge.least_rad, hinge.most_rad)
                                        : uniform_in(random, -kPi, kPi));
  }
  return angles;
}

struct WholeMomentum {
  Vector3 linear{Vector3::Zero()};
  Vector3 angular{Vector3::Zero()};  ///< about the origin
};

inline WholeMomentum momentum_of(const std::vector<BodyState>& states) {
  WholeMomentum whole;
  for (const BodyState& state : states) {
    whole.linear += state.linear_momentum;
    whole.angular += state.angular_momentum + state.pose.position.cross(state.linear_momentum);
  }
  return whole;
}

inline double energy_of(const std::vector<BodyModel>& models, const std::vector<BodyState>& states,
                        const Vector3& gravity_m_s2 = Vector3::Zero()) {
  double energy = 0.0;
  for (std::size_t i = 0; i < models.size(); ++i) {
    if (models[i].inverse_mass > 0.0) {
      energy += kinetic_energy(models[i], states[i]) -
                gravity_m_s2.dot(states[i].pose.position) / models[i].inverse_mass;
    }
  }
  return energy;
}

/// The largest distance between the anchors of a hinge (metres).
inline double widest_gap_m(const Figure& figure, const std::vector<BodyState>& states) {
  double widest = 0.0;
  for (const Hinge& hinge : figure.hinges) {
    widest =
        std::max(widest, anchor_gap_m(hinge, states[static_cast<std::size_t>(hinge.child)].pose,
                                      states[static_cast<std::size_t>(hinge.parent)].pose));
  }
  return widest;
}

/// Gives every part an angular momentum of its own (N m s, at most), and leaves the hinges whole.
inline void stir(const FigureScene& scene, double most, RandomStream& random,
                 std::vector<BodyState>& states) {
  for (std::size_t i = 0; i < states.size(); ++i) {
    states[i].angular_momentum += most * random_direction(random);
  }
  Figures({scene.figure}, scene.models).begin({scene.figure}, states);
}

}  // namespace impetus
