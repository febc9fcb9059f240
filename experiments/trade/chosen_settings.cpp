// SPDX-License-Identifier: MIT
#include "experiments/trade/chosen_settings.hpp"

#include <algorithm>

#include "experiments/trade/trade_bodies.hpp"

namespace impetus {

using nlohmann::json;

json engine_with(const json& scene, const TradeOption& option) {
  const int depth_before = scene["engine"].value("tree_depth", 0);
  json engine = with_trees(scene, option.kind, option.level)["engine"];
  engine["contacts"]["reduction"] = option.reduction;
  if (engine.contains("level")) {
    engine["level"] = option.level;
  }
  if (!engine.contains("schedule")) {
    return engine;
  }
  for (json& list : engine["schedule"]["lists"]) {
    for (const char* key : {"least_level", "greatest_level"}) {
      if (list.contains(key)) {
        const int level = list[key].get<int>();
        const bool was_finest = level == depth_before && key == std::string("greatest_level");
        list[key] = was_finest ? option.level : std::min(level, option.level);
      }
    }
  }
  return engine;
}

json scene_with(json scene, const TradeOption& option) {
  scene["engine"] = engine_with(scene, option);
  for (const char* key : {"schedule", "budget", "region", "level"}) {
    scene["engine"].erase(key);
  }
  return scene;
}

}  // namespace impetus
