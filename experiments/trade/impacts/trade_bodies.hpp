// The bodies of a scene, each with a tree of every kind that is to be measured.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <vector>

#include "experiments/scenes/shape_library.hpp"
#include "experiments/trade/impacts/impact_pair.hpp"

namespace impetus::inline trade {

struct TradeBodies {
  std::vector<ImpactBody> alike;      ///< one for all bodies that are alike
  std::vector<std::size_t> alike_of;  ///< by body of the scene: which of them it is
};

/// The scene with trees of `kind` to `depth`, of the branching that it asks for where the kind can
/// have it. Levels that it states stay: it may no longer be a valid scene.
nlohmann::json with_trees(nlohmann::json scene, TreeKind kind, int depth);

/// Precondition: `scene` is valid by its schema and checks. `progress` hears of each kind's trees.
TradeBodies trade_bodies(const nlohmann::json& scene, double metres_per_degree,
                         const std::vector<TreeKind>& kinds, int depth, ShapeLibrary& library);

}  // namespace impetus::inline trade
