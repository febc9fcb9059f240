// Nothing is computed that nothing asks for: what metrics are asked, what they are told, what a
// meter is asked, and which nodes are transformed.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "engine/scheduling/metrics.hpp"
#include "tests/engine/builders.hpp"

namespace impetus::unused_terms_test {

constexpr std::uint64_t kSeed = 8'023;

/// Distance of the centres from the world's origin, near first; keeps every pair that it measures.
class WatchedMetric final : public PriorityMetric {
 public:
  explicit WatchedMetric(unsigned terms) : PriorityMetric(Urgent::kSmall), terms_(terms) {}
  [[nodiscard]] unsigned terms() const override { return terms_; }
  [[nodiscard]] double measure(const PairBounds& bounds, const Viewer& /*viewer*/,
                               const Fixation& /*fixation*/) const override {
    seen.push_back(bounds);
    return (bounds.a.centre + bounds.b.centre).norm();
  }

  mutable std::vector<PairBounds> seen;

 private:
  unsigned terms_;
};

/// Grants all, and counts how often it is asked.
class CountingWork final : public WorkMeter {
 public:
  std::int64_t request(WorkPhase phase, std::int64_t total, std::int64_t /*reserved*/) override {
    asked += phase == WorkPhase::kRefinement ? 1 : 0;
    return total;
  }

  std::int64_t asked{0};
};

/// Blocks in a cube, with trees of three levels, whose metric is watched.
struct WatchedCube {
  explicit WatchedCube(std::vector<PriorityList> lists, unsigned terms = 0)
      : metric(std::make_shared<WatchedMetric>(terms)) {
    Schedule schedule;
    schedule.metric = metric;
    schedule.lists = std::move(lists);
    schedule.limits.assign(schedule.lists.size() - 1, 0.5);
    world.emplace(enclosed_l_blocks(27, /*depth=*/2, std::move(schedule)));
  }

  const StepReport& step() {
    metric->seen.clear();
    return world->step(step_of(kStep_s), meter);
  }

  std::shared_ptr<WatchedMetric> metric;
  std::optional<World> world;
  CountingWork meter;
};

TEST(UnusedTerms, WhereNoPairWaitsForWorkOnlyWhatTouchesIsMeasuredForTheReport) {
  WatchedCube cube({{1.0, /*least_level=*/2, /*greatest_level=*/2}});
  std::size_t measured = 0;
  for (int step = 0; step < 200; ++step) {
    const StepReport& report = cube.step();
    // A body that touches several walls is one pair.
    std::vector<BodyPair> touching;
    for (const CollisionReport& collision : report.collisions) {
      BodyPair pair = collision.bodies;
      pair.b = is_wall(pair.b) ? kEnclosure : pair.b;
      if (touching.empty() || !(touching.back() == pair)) {
        touching.push_back(pair);
      }
    }
    ASSERT_EQ(cube.metric->seen.size(), touching.size()) << "step " << step;
    measured += touching.size();
  }
  EXPECT_GT(measured, 50U) << "nothing ever touched";
}

TEST(UnusedTerms, WhereNoPairWaitsForWorkTheMeterIsAskedOnceAStep) {
  WatchedCube cube({{1.0, 2, 2}});
  for (int step = 0; step < 50; ++step) {
    cube.step();
  }
  EXPECT_EQ(cube.meter.asked, 50);
}

TEST(UnusedTerms, WherePairsWaitForWorkEachIsMeasuredOnce) {
  WatchedCube cube({{1.0, 0, 2}});
  std::size_t most = 0;
  for (int step = 0; step < 100; ++step) {
    cube.step();
    std::vector<std::pair<std::int32_t, std::int32_t>> pairs;
    for (const PairBounds& bounds : cube.metric->seen) {
      pairs.emplace_back(bounds.pair.a, bounds.pair.b);
    }
    std::sort(pairs.begin(), pairs.end());
    ASSERT_EQ(std::adjacent_find(pairs.begin(), pairs.end()), pairs.end()) << "step " << step;
    most = std::max(most, pairs.size());
  }
  EXPECT_GT(most, 5U);
}

TEST(UnusedTerms, OnePairAloneNeedsNoOrder) {
  const BodyModel block = solid_body(small_l_block(), /*depth=*/2);
  const auto metric = std::make_shared<WatchedMetric>(0);
  WorldSettings settings;
  settings.schedule.metric = metric;
  // Bounding spheres overlap, the blocks do not.
  World world({block, block}, {resting_at({0.0, 0.0, 0.0}), resting_at({0.0, 0.0, 0.12})},
              settings);
  FixedWork enough(kUnlimitedTests);
  const StepReport& report = world.step(step_of(kStep_s), enough);
  ASSERT_TRUE(report.collisions.empty());
  ASSERT_GT(report.work_spent, 1) << "the pair was refined beyond its floor";
  EXPECT_TRUE(metric->seen.empty());
}

TEST(UnusedTerms, OfOneListOnlyPairsThatWaitForWorkAreMeasured) {
  const BodyModel block = solid_body(small_l_block(), /*depth=*/2);
  const auto metric = std::make_shared<WatchedMetric>(0);
  const auto measured_with = [&](std::vector<PriorityList> lists) {
    WorldSettings settings;
    settings.schedule.metric = metric;
    settings.schedule.limits.assign(lists.size() - 1, 0.5);
    settings.schedule.lists = std::move(lists);
    std::vector<BodyState> states;
    for (const double z : {0.0, 0.12, 5.0, 5.12, 9.4}) {
      states.push_back(resting_at({0.0, 0.0, z}));
    }
    // It begins near the last one, and is far from it when the step ends.
    states.push_back(moving(block, {0.0, 0.0, 9.28}, {0.0, 0.0, -0.4 / kStep_s}));
    World world(std::vector<BodyModel>(states.size(), block), states, settings);
    FixedWork enough(kUnlimitedTests);
    metric->seen.clear();
    world.step(step_of(kStep_s), enough);
    std::vector<BodyPair> pairs;
    for (const PairBounds& bounds : metric->seen) {
      pairs.push_back(bounds.pair);
    }
    return pairs;
  };
  EXPECT_EQ(measured_with({{1.0}, {1.0}}), (std::vector<BodyPair>{{0, 1}, {2, 3}, {4, 5}}));
  EXPECT_EQ(measured_with({{1.0}}), (std::vector<BodyPair>{{0, 1}, {2, 3}}));
}

TEST(UnusedTerms, AMetricIsToldTheTermsItLooksAtAndNoOthers) {
  for (const unsigned terms : {0U, 1U, 2U, 3U}) {
    WatchedCube cube({{1.0}, {1.0}}, terms);  // lists by thresholds: every pair is measured
    std::size_t pairs = 0;
    for (int step = 0; step < 60; ++step) {
      const std::vector<BodyState> before = cube.world->states();
      cube.step();
      for (const PairBounds& bounds : cube.metric->seen) {
        EXPECT_EQ(!bounds.velocity_a.isZero(0.0), (terms & kMotionTerm) != 0);
        EXPECT_EQ(!bounds.velocity_b.isZero(0.0), (terms & kMotionTerm) != 0);
        EXPECT_EQ(bounds.fit_error_m > 0.0, (terms & kFitErrorTerm) != 0);
        if ((terms & kMotionTerm) != 0) {
          const auto a = static_cast<std::size_t>(bounds.pair.a);
          EXPECT_EQ(bounds.velocity_a, velocity(cube.world->models()[a], before[a]));
        }
        ++pairs;
      }
    }
    EXPECT_GT(pairs, 20U);
  }
}

PairBounds random_bounds(RandomStream& random) {
  PairBounds bounds;
  bounds.pair = {0, 1};
  bounds.a = {random_in_cube(random, 1.0), uniform_in(random, 0.01, 0.3)};
  bounds.b = {random_in_cube(random, 1.0), uniform_in(random, 0.01, 0.3)};
  bounds.velocity_a = random_in_cube(random, 2.0);
  bounds.velocity_b = random_in_cube(random, 2.0);
  bounds.fit_error_m = uniform_in(random, 0.001, 0.1);
  return bounds;
}

PairBounds without(PairBounds bounds, unsigned terms) {
  const PairBounds empty;
  if ((terms & kMotionTerm) != 0) {
    bounds.velocity_a = empty.velocity_a;
    bounds.velocity_b = empty.velocity_b;
  }
  if ((terms & kFitErrorTerm) != 0) {
    bounds.fit_error_m = empty.fit_error_m;
  }
  return bounds;
}

void expect_it_looks_at_what_it_says(const PriorityMetric& metric, const std::string& name) {
  RandomStream random(kSeed, "terms of " + name);
  const Viewer viewer = step_of(kStep_s).viewer;
  for (const unsigned term : {kMotionTerm, kFitErrorTerm}) {
    int changed = 0;
    for (int trial = 0; trial < 200; ++trial) {
      const PairBounds bounds = random_bounds(random);
      changed +=
          metric.measure(bounds, viewer, {}) != metric.measure(without(bounds, term), viewer, {})
              ? 1
              : 0;
    }
    EXPECT_EQ(changed > 0, (metric.terms() & term) != 0) << name << ", term " << term;
  }
  int followed = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const PairBounds bounds = random_bounds(random);
    const ScreenPoint aside{uniform_in(random, 1.0, 5.0), 0.0};
    followed += metric.measure(bounds, viewer, {}) != metric.measure(bounds, viewer, aside) ? 1 : 0;
  }
  EXPECT_EQ(followed > 0, (metric.terms() & kFixationTerm) != 0) << name << ", fixation";
}

TEST(UnusedTerms, EveryMetricLooksAtTheTermsItSaysAndNoOthers) {
  for (const std::string_view name : metric_names()) {
    if (!needs_terms(name)) {
      expect_it_looks_at_what_it_says(*make_metric(name), std::string(name));
    }
    if (takes_point(name) && !needs_terms(name)) {
      MetricOptions options;
      options.point = ScreenPoint{0.1, 0.1};
      expect_it_looks_at_what_it_says(*make_metric(name, options),
                                      std::string(name) + " of a point");
    }
  }
}

TEST(UnusedTerms, AWeightedSumLooksAtWhatItsMetricsLookAt) {
  MetricOptions options;
  options.terms = {{"eccentricity", 1.0, 0.0, 60.0}};
  expect_it_looks_at_what_it_says(*make_metric("weighted", options), "a sum of eccentricity");
  options.terms.push_back({"velocity", 1.0, 0.0, 60.0});
  expect_it_looks_at_what_it_says(*make_metric("weighted", options), "and velocity");
  options.terms.push_back({"gap-bound", 1.0, 0.1, 0.0});
  expect_it_looks_at_what_it_says(*make_metric("weighted", options), "and gap bound");
}

TEST(UnusedTerms, BodiesThatAreNoCandidatesTransformNoNode) {
  const BodyModel block = solid_body(small_l_block(), /*depth=*/2);
  World world({block, block}, {resting_at({-1.0, 0.0, 0.0}), resting_at({1.0, 0.0, 0.0})}, {});
  for (int step = 0; step < 10; ++step) {
    step_whole(world);
  }
  EXPECT_EQ(world.nodes_transformed(), 0);
}

TEST(UnusedTerms, AListOfRootsTransformsRootsAlone) {
  Schedule schedule;
  schedule.lists = {{1.0, 0, /*greatest_level=*/0}};
  World world = enclosed_l_blocks(27, /*depth=*/2, schedule);
  std::int64_t before = 0;
  for (int step = 0; step < 60; ++step) {
    step_whole(world);
    ASSERT_LE(world.nodes_transformed() - before, 27) << "each body's root once";
    before = world.nodes_transformed();
  }
  EXPECT_GT(before, 0) << "nothing was ever near";
}

}  // namespace impetus::unused_terms_test
