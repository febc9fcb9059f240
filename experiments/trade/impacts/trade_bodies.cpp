// SPDX-License-Identifier: MIT
#include "experiments/trade/impacts/trade_bodies.hpp"

#include <map>
#include <string>
#include <tuple>

#include "experiments/scenes/scene_bodies.hpp"

namespace impetus::inline trade {
namespace {

using nlohmann::json;

/// Bodies that agree in these are alike; colour and name do not matter.
using Likeness = std::tuple<const BodyShape*, double, bool, int>;

Likeness likeness_of(const SceneBodies& bodies, std::size_t body) {
  const BodyModel& model = bodies.models[body];
  return {bodies.shapes[body], model.inverse_mass, model.inverse_inertia == Matrix3::Zero(),
          model.material};
}

TradeBodies without_trees(const SceneBodies& bodies) {
  TradeBodies found;
  std::map<Likeness, std::size_t> known;
  std::map<std::string, int> names;
  for (std::size_t body = 0; body < bodies.models.size(); ++body) {
    const auto [place, is_new] = known.emplace(likeness_of(bodies, body), found.alike.size());
    found.alike_of.push_back(place->second);
    if (is_new) {
      std::string name = bodies.shape_names[body];
      const int of_this_name = ++names[name];
      if (of_this_name > 1) {
        name += " " + std::to_string(of_this_name);
      }
      found.alike.push_back({name, bodies.looks[body], bodies.models[body], {}});
      found.alike.back().model.tree.reset();
    }
  }
  return found;
}

}  // namespace

json with_trees(json scene, TreeKind kind, int depth) {
  json& engine = scene["engine"];
  TreeSettings settings{kind, depth};
  settings.branching = engine.value("tree", json::object()).value("branching", settings.branching);
  if (!problem_of(settings).empty()) {
    settings.branching = TreeSettings{}.branching;
  }
  engine["tree"] = {{"kind", name_of(kind)}, {"branching", settings.branching}};
  engine["tree_depth"] = depth;
  return scene;
}

TradeBodies trade_bodies(const json& scene, double metres_per_degree,
                         const std::vector<TreeKind>& kinds, int depth, ShapeLibrary& library) {
  TradeBodies found;
  for (const TreeKind kind : kinds) {
    const SceneBodies bodies =
        bodies_of(with_trees(scene, kind, depth), metres_per_degree, library);
    if (found.alike.empty()) {
      found = without_trees(bodies);
    }
    for (std::size_t body = 0; body < bodies.models.size(); ++body) {
      found.alike[found.alike_of[body]].trees[kind] = bodies.models[body].tree;
    }
  }
  return found;
}

}  // namespace impetus::inline trade
