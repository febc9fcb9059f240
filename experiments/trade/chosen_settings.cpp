// SPDX-License-Identifier: MIT
#include "experiments/trade/chosen_settings.hpp"

#include <algorithm>

#include "experiments/trade/impacts/trade_bodies.hpp"

namespace impetus::inline trade {

using nlohmann::json;

namespace {

/// A list that went to the finest level goes to `level`, others no deeper.
void limit(json& list, int depth_before, int level) {
  const int greatest = list.value("greatest_level", depth_before);
  list["greatest_level"] = greatest == depth_before ? level : std::min(greatest, level);
  if (list.contains("least_level")) {
    list["least_level"] = std::min(list["least_level"].get<int>(), level);
  }
}

}  // namespace

json engine_with(const json& scene, const TradeOption& option, int depth) {
  const int depth_before = scene["engine"].value("tree_depth", 0);
  json engine = with_trees(scene, option.kind, depth)["engine"];
  engine["contacts"]["reduction"] = option.reduction;
  if (!engine.contains("schedule")) {
    engine["level"] = option.level;
    return engine;
  }
  for (json& list : engine["schedule"]["lists"]) {
    limit(list, depth_before, option.level);
  }
  return engine;
}

json scene_with(json scene, const TradeOption& option, int depth) {
  for (const char* key : {"schedule", "budget", "region"}) {
    scene["engine"].erase(key);
  }
  scene["engine"] = engine_with(scene, option, depth);
  return scene;
}

}  // namespace impetus::inline trade
