// Small pairs of bodies to measure a trade on.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "engine/shapes/mass_properties.hpp"
#include "engine/trees/builders/build_tree.hpp"
#include "experiments/trade/impacts/impact_measures.hpp"

namespace impetus {

/// A clock that stands still: no row depends on a time.
class StillClock final : public Clock {
 public:
  [[nodiscard]] std::int64_t now_ns() const override { return 0; }
};

inline std::vector<TreeKind> all_kinds() {
  std::vector<TreeKind> kinds;
  for (const std::string& name : tree_kind_names()) {
    kinds.push_back(tree_kind(name));
  }
  return kinds;
}

/// A body of 1,000 kg/m³ with a tree of each of the kinds.
inline ImpactBody impact_body(std::string name, const TriangleMesh& shape,
                              const std::vector<TreeKind>& kinds, int depth) {
  const TriangleMesh mesh = about_centre_of_mass(shape);
  const MassProperties mass = solid_of(mesh, 1'000.0);
  ImpactBody body;
  body.name = std::move(name);
  body.look.mesh = std::make_shared<const TriangleMesh>(mesh);
  for (const Vector3& vertex : mesh.vertices) {
    body.look.radius_m = std::max(body.look.radius_m, vertex.norm());
  }
  body.model.inverse_mass = 1.0 / mass.mass_kg;
  body.model.inverse_inertia = mass.inertia.inverse();
  for (const TreeKind kind : kinds) {
    body.trees[kind] = std::make_shared<const VolumeTree>(build_tree(mesh, {kind, depth, 8}));
  }
  return body;
}

/// Two bodies alike that meet at 1 m/s, spinning, seen from 57 cm.
inline ImpactPair impact_pair(const ImpactBody& body) {
  ImpactPair pair;
  pair.a = pair.b = body;
  pair.motions = {{1.0, 2.0, 3.0}};
  pair.restitution = 0.5;
  ScreenGeometry screen;
  screen.viewing_distance_m = 0.57;
  pair.viewer = viewer_at(screen, 0.0);
  return pair;
}

}  // namespace impetus
