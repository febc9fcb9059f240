// SPDX-License-Identifier: MIT
#include "experiments/trade/impacts/scene_pairs.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <utility>

#include "engine/dynamics/restitution.hpp"
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

namespace {

/// Which are alike, the lesser first.
using Kinship = std::pair<std::size_t, std::size_t>;

ImpactPair pair_of(const TradeBodies& bodies, const Kinship& of, const StagedScene& scene) {
  const WorldSettings& settings = scene.world.settings();
  ImpactPair pair;
  pair.a = bodies.alike[of.first];
  pair.b = bodies.alike[of.second];
  const Restitutions restitutions{settings.restitution, settings.materials, settings.wall_material};
  pair.restitution = restitutions.of(pair.a.model.material, pair.b.model.material);
  pair.response = settings.response;
  pair.most_contacts = settings.contacts.most_per_pair;
  pair.viewer = scene.viewer;
  return pair;
}

std::vector<ScenePair> pairs_that_met(const TradeBodies& bodies, const SceneDemand& demand,
                                      const StagedScene& scene) {
  std::map<Kinship, ScenePair> met;
  for (const BodyMeeting& meeting : demand.meetings) {
    Kinship of{bodies.alike_of[meeting.body_a], bodies.alike_of[meeting.body_b]};
    MeetingMotion motion = meeting.motion;
    if (of.second < of.first) {
      std::swap(of.first, of.second);
      std::swap(motion.spin_a_rad_s, motion.spin_b_rad_s);
    }
    const auto [place, is_new] = met.try_emplace(of);
    if (is_new) {
      place->second.pair = pair_of(bodies, of, scene);
    }
    place->second.pair.motions.push_back(motion);
    ++place->second.meetings;
  }
  std::vector<ScenePair> pairs;
  pairs.reserve(met.size());
  for (auto& [of, pair] : met) {
    pairs.push_back(std::move(pair));
  }
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const ScenePair& x, const ScenePair& y) { return x.meetings > y.meetings; });
  return pairs;
}

std::vector<ScenePair> pairs_that_could_meet(const TradeBodies& bodies, const StagedScene& scene) {
  std::set<Kinship> seen;
  std::vector<ScenePair> pairs;
  for (std::size_t a = 0; a < bodies.alike_of.size(); ++a) {
    for (std::size_t b = a + 1; b < bodies.alike_of.size(); ++b) {
      const Kinship of = std::minmax(bodies.alike_of[a], bodies.alike_of[b]);
      if (!seen.insert(of).second) {
        continue;
      }
      ImpactPair pair = pair_of(bodies, of, scene);
      const double speed_m_s = pair.size_m();
      pair.motions = {{speed_m_s, 0.5 * speed_m_s / pair.a.look.radius_m,
                       0.5 * speed_m_s / pair.b.look.radius_m}};
      if (pair.a.model.inverse_mass > 0.0 || pair.b.model.inverse_mass > 0.0) {
        pairs.push_back({std::move(pair), 1});
      }
    }
  }
  return pairs;
}

}  // namespace

std::vector<ScenePair> scene_pairs(const TradeBodies& bodies, const SceneDemand& demand,
                                   const StagedScene& scene, std::size_t most) {
  std::vector<ScenePair> pairs = demand.meetings.empty() ? pairs_that_could_meet(bodies, scene)
                                                         : pairs_that_met(bodies, demand, scene);
  pairs.resize(std::min(pairs.size(), most));
  return pairs;
}

}  // namespace impetus::inline trade
