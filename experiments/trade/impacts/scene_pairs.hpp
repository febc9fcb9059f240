// The pairs of bodies whose impacts stand for a scene's.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "experiments/trade/impacts/trade_bodies.hpp"
#include "experiments/trade/scene_demand.hpp"

namespace impetus::inline trade {

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
