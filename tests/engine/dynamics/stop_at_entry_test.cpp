// Who stops whom in a step: on the ways that are gone in the end nobody is deep in anybody, and who
// falls keeps its energy.
// SPDX-License-Identifier: MIT
#include "engine/dynamics/stop_at_entry.hpp"

#include <gtest/gtest.h>

#include "engine/collision/broad_phase.hpp"
#include "tests/engine/builders.hpp"
#include "tests/engine/depth_on_the_way.hpp"
#include "tests/engine/shots.hpp"

namespace impetus::stop_at_entry_test {

constexpr std::uint64_t kSeed = 49;
constexpr double kDtS = 0.5;
constexpr int kBodies = 12;

/// Bodies of random trees that fly at the middle of them all, more or less, and fast, as a step
/// moves them.
struct Crowd {
  std::vector<BodyModel> models;
  std::vector<BodyState> before;
  std::vector<BodyState> after;
  std::vector<Fall> falls;
  std::vector<PlacedTree> placed;
  std::vector<PairBounds> candidates;
  EntryMemory memory;
  int most_stops{kMostStops};
  std::int64_t granted{kUnlimitedTests};  ///< of work

  Crowd(RandomStream& random, const Vector3& gravity_m_s2, double spin, double most_held_s = 0.0) {
    const Vector3 middle(0.0, 1.5, 1.5);
    for (int i = 0; i < kBodies; ++i) {
      const Vector3 place(3.0 * (i % 3 - 1), 3.0 * (i / 3 % 2), 3.0 * (i / 6 % 2));
      models.push_back(random_body(random, 4));
      before.push_back(
          moving(models.back(), place, (middle - place + random_direction(random)) / kDtS));
      before.back().pose.orientation = random_turn(random);
      before.back().angular_momentum = random_in_cube(random, spin);
      before.back().held_s = most_held_s * random.uniform();
      falls.push_back({gravity_m_s2});
    }
    after = before;
    std::vector<MovedBound> bounds;
    for (std::size_t body = 0; body < models.size(); ++body) {
      const VolumeTree& tree = *models[body].tree;
      const double way_m =
          advance(models[body], after[body], kDtS, Rotation::kEnergyKept, falls[body]);
      bounds.push_back({{after[body].pose.position, tree.bounding_radius_m()}, way_m, true});
      placed.emplace_back(tree);
    }
    candidates = candidate_pairs(bounds);
  }

  const Stopping& stop() {
    StepMade step{
        kDtS, models, before, candidates, kUnlimitedLevel, WorkCosts{}, Rotation::kEnergyKept};
    step.falls = falls;
    step.most_stops = most_stops;
    WorkGrants grants;
    grants.of(WorkPhase::kEntry) = granted;
    FixedWork meter(grants);
    WorkGrants noted;
    PhaseWork work(meter, WorkPhase::kEntry, noted);
    step.work = &work;
    return stop_at_entry(step, after, placed, memory);
  }

  /// On the ways that they went; on their whole ways, up to where it stopped, where all that could
  /// meet stop together.
  [[nodiscard]] PairOnTheWay on_the_way(BodyPair pair) {
    const std::vector<BodyPath>& ways = most_stops > 0 ? memory.ways : memory.whole_ways;
    const std::size_t a = at(pair.a);
    const std::size_t b = at(pair.b);
    return {placed[a], placed[b], ways[a], ways[b], kUnlimitedLevel};
  }
  [[nodiscard]] double gone(BodyPair pair) const {
    return most_stops > 0 ? 1.0 : memory.ways[at(pair.a)].stop;
  }

  [[nodiscard]] double energy_J(std::size_t body, const BodyState& state) const {
    const Vector3& gravity = falls[body].gravity_m_s2;
    return kinetic_energy(models[body], state) -
           gravity.dot(state.pose.position) / models[body].inverse_mass;
  }
};

// A hair deep, an eighth of a slow way, when they are stopped, and a quarter that is not worth a
// stop; but for those that are told of as not searched.
TEST(StopAtEntry, NobodyIsDeepInAnybodyOnTheWaysThatAreGone) {
  RandomStream random(kSeed, "ways");
  int pairs = 0;
  std::size_t stopped = 0;
  std::size_t unsearched = 0;
  for (int trial = 0; trial < 180; ++trial) {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", trial " + std::to_string(trial));
    const Vector3 gravity = trial % 2 == 0 ? Vector3(Vector3::Zero()) : Vector3(0.0, -3.0, 0.0);
    Crowd crowd(random, gravity, trial % 3 == 0 ? 6.0 : 0.05, trial % 4 == 0 ? 0.7 * kDtS : 0.0);
    crowd.most_stops = trial % 5 == 0 ? 0 : kMostStops;
    if (trial >= 120) {
      crowd.granted = 150 * (trial - 119);
    }
    const Stopping& stopping = crowd.stop();
    stopped += stopping.stopped.size();
    unsearched += stopping.unsearched.size();
    for (const PairBounds& candidate : crowd.candidates) {
      const PairOnTheWay pair = crowd.on_the_way(candidate.pair);
      const double slow_m = slow_way_m(pair.a.tree(), pair.b.tree(), kUnlimitedLevel);
      if (stopping.lacked_tests(candidate.pair) || !is_fast(pair) || depth_at(pair, 0.0) > 0.0) {
        continue;
      }
      ++pairs;
      const double gone_at_last = crowd.gone(candidate.pair);
      for (int moment = 0; moment <= 60; ++moment) {
        ASSERT_LE(depth_at(pair, gone_at_last * moment / 60.0), 0.375 * slow_m + 1e-12)
            << "moment " << moment;
      }
    }
  }
  EXPECT_GT(pairs, 600);
  EXPECT_GT(stopped, 200U);
  EXPECT_GT(unsearched, 100U);
}

TEST(StopAtEntry, WhereNobodyFallsBodiesAreOnTheirWaysWhereTheyWouldBeThen) {
  RandomStream random(kSeed, "moments");
  for (int trial = 0; trial < 30; ++trial) {
    Crowd crowd(random, Vector3::Zero(), 0.05, 0.7 * kDtS);
    crowd.stop();
    for (std::size_t body = 0; body < kBodies; ++body) {
      const BodyPath& way = crowd.memory.ways[body];
      for (double moment = 0.05; moment < way.stop; moment += 0.1) {
        BodyState then = crowd.before[body];
        advance(crowd.models[body], then, moment * kDtS, Rotation::kEnergyKept);
        EXPECT_LT((pose_at(way, moment).position - then.pose.position).norm(), 1e-9);
      }
    }
  }
}

TEST(StopAtEntry, WhoFallsStopsWithTheEnergyOfItsFall) {
  RandomStream random(kSeed, "falls");
  int stopped = 0;
  for (int trial = 0; trial < 30; ++trial) {
    Crowd crowd(random, random_in_cube(random, 9.0), 0.05);
    crowd.stop();
    for (std::size_t body = 0; body < kBodies; ++body) {
      const double energy_J = crowd.energy_J(body, crowd.before[body]);
      EXPECT_NEAR(crowd.energy_J(body, crowd.after[body]), energy_J, 1e-9 * std::abs(energy_J));
      stopped += crowd.memory.stops[body] > 0 ? 1 : 0;
    }
  }
  EXPECT_GT(stopped, 100);
}

}  // namespace impetus::stop_at_entry_test
