// The pairs of bodies whose impacts stand for a scene's.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <vector>

#include "experiments/scenes/shape_library.hpp"
#include "experiments/trade/impacts/impact_pair.hpp"
#include "experiments/trade/scene_demand.hpp"

namespace impetus::inline trade {

/// The bodies of a scene, each with a tree of every kind that is to be measured.
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

/// Bodies that meet in a scene, and how often.
struct ScenePair {
  ImpactPair pair;
  std::int64_t meetings{0};
};

/// Those that met in `demand`, the commonest first, at most `most`. Where nobody met: every two
/// that could, at one size a second and spins whose surfaces move at up to half of that. Empty when
/// no two bodies can meet.
std::vector<ScenePair> scene_pairs(const TradeBodies& bodies, const SceneDemand& demand,
                                   const StagedScene& scene, std::size_t most);

}  // namespace impetus::inline trade
