// What `impetus trade` measures: estimates, first touches of bounds, errors and costs of impacts.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "engine/collision/pair_refinement.hpp"
#include "engine/shapes/solids/block_meshes.hpp"
#include "engine/shapes/solids/ring_meshes.hpp"
#include "experiments/trade/estimate.hpp"
#include "experiments/trade/impacts/impact_rows.hpp"
#include "experiments/trade/impacts/level_touch.hpp"
#include "experiments/trade/trade_option.hpp"
#include "tests/experiments/trade_pairs.hpp"

namespace impetus::trade_measures_test {

constexpr std::uint64_t kSeed = 5;

// ---------------------------------------------------------------- estimates

TEST(Estimate, MedianOfTenLiesBetweenTheSecondAndTheNinth) {
  // P(at most 1 of 10 below the median) = 11/1024 < .025 < 56/1024 = P(at most 2).
  const Estimate found = quantile_of({10, 9, 8, 7, 6, 5, 4, 3, 2, 1}, 0.5);
  EXPECT_EQ(found.n, 10);
  EXPECT_EQ(found.value, 5.0);
  EXPECT_EQ(found.low, 2.0);
  EXPECT_EQ(found.high, 9.0);
}

TEST(Estimate, EndsThatTooFewValuesCannotTellAreMissing) {
  EXPECT_TRUE(std::isnan(quantile_of({1, 2, 3}, 0.5).low));
  EXPECT_TRUE(std::isnan(quantile_of({1, 2, 3}, 0.5).high));
  const Estimate rare = quantile_of(std::vector<double>(100, 7.0), 0.99);
  EXPECT_EQ(rare.low, 7.0);
  EXPECT_TRUE(std::isnan(rare.high));  // .99^100 > .025
  EXPECT_TRUE(std::isnan(quantile_of({}, 0.5).value));
}

TEST(Estimate, IntervalsOfQuantilesHoldTheTrueOneNineteenTimesInTwenty) {
  RandomStream random(kSeed, "coverage");
  for (const double p : {0.5, 0.95}) {
    constexpr int kRepetitions = 1'000;
    int held = 0;
    for (int repetition = 0; repetition < kRepetitions; ++repetition) {
      std::vector<double> values(200);
      std::generate(values.begin(), values.end(), [&] { return random.uniform(); });
      const Estimate found = quantile_of(values, p);
      held += found.low <= p && p <= found.high ? 1 : 0;
    }
    // 95 % at least, less three standard errors of 1,000 repetitions.
    EXPECT_GE(held, 930) << p;
    EXPECT_LE(held, 990) << p;
  }
}

TEST(Estimate, SharesHaveTheIntervalsOfClopperAndPearson) {
  constexpr double kTable = 5e-5;  // four digits of their table
  const Estimate half = share_of(5, 10);
  EXPECT_EQ(half.value, 0.5);
  EXPECT_NEAR(half.low, 0.1871, kTable);
  EXPECT_NEAR(half.high, 0.8129, kTable);
  EXPECT_EQ(share_of(0, 10).low, 0.0);
  EXPECT_NEAR(share_of(0, 10).high, 0.3085, kTable);
  EXPECT_EQ(share_of(10, 10).high, 1.0);
}

// ---------------------------------------------------------------- first touch of bounds

bool overlap_at(PlacedTree& a, const Pose& pose, PlacedTree& b, int level) {
  a.move_to(pose);
  PairRefinement pair(a, b, level);
  while (!pair.resolved()) {
    pair.refine_one_block();
  }
  return !pair.overlapping().empty();
}

TEST(LevelTouch, IsTheFirstWayAtWhichARefinementFindsOverlap) {
  const ImpactPair pair =
      impact_pair(impact_body("L-block", l_block_mesh(0.2, 0.07), all_kinds(), 2));
  RandomStream random(kSeed, "lines");
  std::map<bool, int> found;
  for (int trial = 0; trial < 12; ++trial) {
    const Approach approach = next_approach(random, pair);
    for (const auto& [kind, tree] : pair.a.trees) {
      PlacedTree a(*tree);
      PlacedTree b(*tree);
      b.move_to(approach.pose_b);
      const auto moved = [&](double way_m) {
        return Pose{approach.pose_a.position + way_m * approach.direction,
                    approach.pose_a.orientation};
      };
      for (int level = 0; level <= 2; ++level) {
        a.move_to(approach.pose_a);
        const auto way_m = first_touch_of_bounds(a, b, approach.direction, level);
        ++found[way_m.has_value()];
        const double reach_m = 2.0 * pair.a.look.radius_m;
        const double end_m = way_m.value_or(8.0 * reach_m);
        const double step_m = 0.02 * reach_m;
        for (double before_m = 0.0; before_m < end_m - 1e-9; before_m += step_m) {
          ASSERT_FALSE(overlap_at(a, moved(before_m), b, level))
              << name_of(kind) << ", level " << level << ", trial " << trial;
        }
        if (way_m) {
          ASSERT_TRUE(overlap_at(a, moved(*way_m + 1e-9), b, level))
              << name_of(kind) << ", level " << level << ", trial " << trial;
        }
      }
    }
  }
  EXPECT_GT(found[true], 20);
  EXPECT_GT(found[false], 20);
}

// ---------------------------------------------------------------- impacts

TEST(Impacts, OfABoxInItsOwnBoxAreExactInEverything) {
  const ImpactPair pair =
      impact_pair(impact_body("box", box_mesh({0.2, 0.14, 0.08}), {TreeKind::kBox}, 0));
  ImpactSettings settings{{TreeKind::kBox}, {0}, {"average", "none"}, 60, kSeed};
  const ImpactMeasures measures = measure_impacts(pair, settings, StillClock());
  // What is left is the depth the bodies were moved on by: 1e-7 of their radius.
  constexpr double kMovedOn = 1e-4;
  for (const ContactMeasures& each : measures.contacts) {
    EXPECT_EQ(each.exact.normal_deg.size(), 60U);
    for (const std::vector<double>* errors :
         {&each.exact.normal_deg, &each.exact.point, &each.exact.linear, &each.exact.angular}) {
      EXPECT_LT(quantile_of(*errors, 0.95).value, kMovedOn) << each.reduction;
    }
  }
  const BoundsMeasures& bounds = measures.bounds.at(0);
  EXPECT_EQ(bounds.collisions, measures.touching);
  EXPECT_EQ(bounds.false_collisions, 0);
  EXPECT_LT(quantile_of(bounds.gaps, 0.99).value, 1e-6);
}

TEST(Impacts, ABallIsItsOwnTreeAndExactAgainstAMesh) {
  ImpactBody ball;
  ball.name = "sphere";
  ball.look.radius_m = 0.1;
  ball.model.inverse_mass = 1.0;
  ball.model.inverse_inertia = Matrix3::Identity() / 0.004;
  ball.trees[TreeKind::kBox] = std::make_shared<const VolumeTree>(
      single_node_tree(Sphere{Vector3::Zero(), ball.look.radius_m}));
  ImpactPair pair =
      impact_pair(impact_body("box", box_mesh({0.2, 0.14, 0.08}), {TreeKind::kBox}, 0));
  pair.b = ball;
  const ImpactMeasures measures =
      measure_impacts(pair, {{TreeKind::kBox}, {0}, {"average"}, 30, kSeed}, StillClock());
  EXPECT_LT(quantile_of(measures.contacts.at(0).exact.normal_deg, 0.95).value, 1e-3);
  EXPECT_EQ(measures.bounds.at(0).false_collisions, 0);
}

const ImpactMeasures& torus_measures() {
  static const ImpactMeasures measures = [] {
    const ImpactPair pair =
        impact_pair(impact_body("torus", torus_mesh(0.08, 0.03, 16, 8), all_kinds(), 2));
    ImpactSettings settings{all_kinds(), {0, 1, 2}, {"average", "groups"}, 60, kSeed};
    return measure_impacts(pair, settings, StillClock());
  }();
  return measures;
}

TEST(Impacts, ErrorsFallWithTheLevelOnAverageForEveryKind) {
  std::map<TreeKind, std::map<int, double>> gaps;
  std::map<TreeKind, std::map<int, double>> velocities;
  std::map<TreeKind, std::map<int, double>> normals;
  for (const BoundsMeasures& each : torus_measures().bounds) {
    EXPECT_EQ(each.missed, 0) << name_of(each.kind);
    gaps[each.kind][each.level] = mean_of(each.gaps).value;
  }
  for (const ContactMeasures& each : torus_measures().contacts) {
    if (each.reduction == "average") {  // normals of few cells of a grid are chance
      velocities[each.kind][each.level] = mean_of(each.exact.linear).value;
      normals[each.kind][each.level] = mean_of(each.exact.normal_deg).value;
    }
  }
  ASSERT_EQ(gaps.size(), tree_kind_names().size());
  for (const auto* errors : {&gaps, &velocities, &normals}) {
    for (const auto& [kind, by_level] : *errors) {
      // The eight cells of a voxel tree's first level fill its root.
      const int first = kind == TreeKind::kVoxel ? 1 : 0;
      for (int level = first + 1; level <= 2; ++level) {
        EXPECT_LT(by_level.at(level), by_level.at(level - 1)) << name_of(kind) << level;
      }
    }
  }
}

TEST(Impacts, TheFinestLevelDoesNotErrAgainstItself) {
  for (const ContactMeasures& each : torus_measures().contacts) {
    const bool is_finest = each.level == 2;
    EXPECT_EQ(mean_of(each.finest.linear).value == 0.0, is_finest) << name_of(each.kind);
  }
}

TEST(Impacts, FinerBoundsTouchLaterAndLessOftenFalsely) {
  const auto& bounds = torus_measures().bounds;
  for (std::size_t i = 1; i < bounds.size(); ++i) {
    if (bounds[i].kind == bounds[i - 1].kind) {
      EXPECT_LE(bounds[i].false_collisions, bounds[i - 1].false_collisions);
      EXPECT_GE(mean_of(bounds[i].tests).value, mean_of(bounds[i - 1].tests).value);
    }
  }
}

std::string rows_without_times(const ImpactMeasures& measures) {
  std::vector<TradeRow> rows = impact_rows(measures);
  std::erase_if(rows, [](const TradeRow& row) { return row.by_clock; });
  return csv_of(rows);
}

/// Every look at it is a random time later than the last.
class ErraticClock final : public Clock {
 public:
  explicit ErraticClock(std::uint64_t seed) : random_(seed, "clock") {}
  [[nodiscard]] std::int64_t now_ns() const override {
    return now_ns_ += static_cast<std::int64_t>(random_.below(50'000));
  }

 private:
  mutable RandomStream random_;
  mutable std::int64_t now_ns_{0};
};

TEST(Impacts, TheSameSeedGivesTheSameRowsWhateverTheTimes) {
  const ImpactPair pair = impact_pair(
      impact_body("L-block", l_block_mesh(0.2, 0.07), {TreeKind::kOctree, TreeKind::kBox}, 1));
  const auto rows_of = [&](std::uint64_t seed, std::uint64_t clock_seed) {
    ImpactSettings settings{{TreeKind::kOctree, TreeKind::kBox}, {0, 1}, {"groups"}, 20, seed};
    return rows_without_times(measure_impacts(pair, settings, ErraticClock(clock_seed)));
  };
  EXPECT_EQ(rows_of(1, 1), rows_of(1, 2));
  EXPECT_NE(rows_of(1, 1), rows_of(2, 1));
}

TEST(Impacts, PooledMeasuresAreThoseOfAll) {
  ImpactMeasures twice = pooled({torus_measures(), torus_measures()}, "both");
  EXPECT_EQ(twice.subject, "both");
  EXPECT_EQ(twice.approaches, 2 * torus_measures().approaches);
  ASSERT_EQ(twice.contacts.size(), torus_measures().contacts.size());
  EXPECT_EQ(twice.contacts[3].exact.normal_deg.size(),
            2 * torus_measures().contacts[3].exact.normal_deg.size());
}

TEST(TradeRows, AreQuotedWhereCsvNeedsIt) {
  TradeRow row;
  row.part = "impacts";
  row.subject = "a \"b\", c";
  row.value = 1.0 / 3.0;
  const std::string text = csv_of({row});
  EXPECT_EQ(text.substr(text.find('\n') + 1),
            "impacts,\"a \"\"b\"\", c\",,,,,,,,,,,,0,0.333333333,,,false\n");
}

// ---------------------------------------------------------------- following the advice

TEST(TradeOptions, FollowedOnFreshImpactsTheyMeasureAsAdvisedWithinTheirIntervals) {
  const ImpactBody body = impact_body("torus", torus_mesh(0.08, 0.03, 16, 8),
                                      {TreeKind::kMedial, TreeKind::kOctree}, 2);
  const auto options_with = [&](std::uint64_t seed) {
    ImpactSettings settings{
        {TreeKind::kMedial, TreeKind::kOctree}, {0, 1, 2}, {"average", "groups"}, 80, seed};
    return trade_options(measure_impacts(impact_pair(body), settings, StillClock()));
  };
  const auto advised = options_with(1);
  const auto fresh = options_with(2);
  const auto agree = [](const Estimate& x, const Estimate& y) {
    return !(x.high < y.low) && !(y.high < x.low);  // an end that is not known excludes nothing
  };
  const TradeOption best = ranked(advised, /*pairs=*/1.0, /*budget_ms=*/1.0).front();
  for (std::size_t i = 0; i < advised.size(); ++i) {
    const bool is_best = advised[i].kind == best.kind && advised[i].level == best.level &&
                         advised[i].reduction == best.reduction;
    if (is_best) {
      EXPECT_TRUE(agree(advised[i].normal_deg, fresh[i].normal_deg));
      EXPECT_TRUE(agree(advised[i].gap_arcmin, fresh[i].gap_arcmin));
      EXPECT_TRUE(agree(advised[i].linear, fresh[i].linear));
      EXPECT_FALSE(agree(advised[i].normal_deg, fresh[0].normal_deg)) << "tells nothing apart";
    }
  }
}

TradeOption option_of(double mean_us, double normal_deg, double gap_arcmin) {
  TradeOption option;
  option.mean_us = option.p99_us = mean_us;
  option.normal_deg.value = normal_deg;
  option.gap_arcmin.value = gap_arcmin;
  return option;
}

TEST(TradeOptions, TheBestWithinABudgetHasTheLeastProductOfErrorsAndOfEqualsIsTheQuickest) {
  const std::vector<TradeOption> options{option_of(1, 20, 20), option_of(5, 10, 10),
                                         option_of(4, 5, 20), option_of(50, 1, 1)};
  EXPECT_EQ(ranked(options, 1.0, 0.01).front().mean_us, 4.0);
  EXPECT_EQ(ranked(options, 1.0, 1.0).front().mean_us, 50.0);
  EXPECT_EQ(ranked(options, 10.0, 0.01).front().mean_us, 1.0);
  EXPECT_TRUE(ranked(options, 100.0, 0.01).empty());
}

}  // namespace impetus::trade_measures_test
