// SPDX-License-Identifier: MIT
#include "experiments/trade/impacts/scene_pairs.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "engine/dynamics/restitution.hpp"

namespace impetus::inline trade {
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
