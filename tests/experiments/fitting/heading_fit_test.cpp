// How unsteady people's imagination is, found from marks and answers by the share of imagined runs.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <mutex>
#include <vector>

#include "experiments/fitting/fit.hpp"
#include "experiments/observers/imagining/noise_ladder.hpp"
#include "tests/experiments/fitting/answering_group.hpp"

namespace impetus::heading_fit_test {

TEST(NoiseLadder, ReadsBetweenItsRungsAndNotBeyondThem) {
  const Percept shares{1.0, 0.9, 0.8, 0.7, 0.6, 0.5, 0.4, 0.3, 0.2, 0.1, 0.0};  // .25 ... 8 degrees
  EXPECT_EQ(share_at_noise(shares, 0.25), 1.0);
  EXPECT_NEAR(share_at_noise(shares, 0.5), 0.8, 1e-12);
  EXPECT_NEAR(share_at_noise(shares, 0.25 * std::exp2(0.25)), 0.95, 1e-12);
  EXPECT_EQ(share_at_noise(shares, 0.0), 1.0);
  EXPECT_NEAR(share_at_noise(shares, 8.0), 0.0, 1e-12);
  EXPECT_EQ(share_at_noise(shares, 80.0), 0.0);
}

// A ladder of one step goes through every rung, and has no corner there: its slope is the same on
// both sides.
TEST(NoiseLadder, IsSmoothAtARung) {
  const Percept shares{1.0, 1.0, 1.0, 1.0, 0.8, 0.3, 0.1, 0.0, 0.0, 0.0, 0.0};
  const auto at_rung = [&](double rung) {
    return share_at_noise(shares, 0.25 * std::exp2(rung / 2.0));
  };
  for (int rung = 1; rung < 10; ++rung) {
    constexpr double kNear = 1e-5;
    EXPECT_NEAR(at_rung(rung), shares[static_cast<std::size_t>(rung)], 1e-9) << rung;
    const double slope_below = (at_rung(rung) - at_rung(rung - kNear)) / kNear;
    const double slope_above = (at_rung(rung + kNear) - at_rung(rung)) / kNear;
    EXPECT_NEAR(slope_below, slope_above, 1e-3) << rung;
  }
  EXPECT_EQ(at_rung(2.5), 1.0);  // no swing before a fall
}

TEST(NoiseLadder, AsksForEachRungWithTheSameDraws) {
  std::mutex mutex;
  std::map<double, std::vector<double>> draws_by_noise;
  const Percept shares =
      shares_by_noise(ImaginingParameters{}, 1, [&](const Imagination& by, RandomStream& draws) {
        const std::lock_guard lock(mutex);
        draws_by_noise[by.heading_noise_deg].push_back(draws.uniform());
        return 0.1 * by.heading_noise_deg;
      });
  ASSERT_EQ(draws_by_noise.size(), shares.size());
  EXPECT_NEAR(draws_by_noise.begin()->first, 0.25, 1e-12);
  EXPECT_NEAR(draws_by_noise.rbegin()->first, 8.0, 1e-12);
  std::size_t rung = 0;
  for (const auto& [noise, draws] : draws_by_noise) {
    EXPECT_EQ(draws, draws_by_noise.begin()->second) << noise;
    EXPECT_NEAR(shares[rung++], 0.1 * noise, 1e-12);
  }
}

// One stream for all clips would leave the same chance in the shares of each.
TEST(NoiseLadder, AsksForEachClipWithItsOwnDraws) {
  const auto first_draw = [](std::uint64_t clip) {
    return shares_by_noise(
               ImaginingParameters{}, clip,
               [](const Imagination& /*any*/, RandomStream& draws) { return draws.uniform(); })
        .front();
  };
  EXPECT_EQ(first_draw(1), first_draw(1));
  EXPECT_NE(first_draw(1), first_draw(2));
}

TEST(NoiseLadder, WhereTheFirstRunsEndAlikeNoMoreAreMade) {
  std::atomic<std::int64_t> runs{0};
  const Percept shares =
      shares_by_noise(ImaginingParameters{}, 1, [&](const Imagination& by, RandomStream& /*none*/) {
        runs += by.runs;
        return by.heading_noise_deg > 7.0 ? 0.5 : 1.0;
      });
  EXPECT_EQ(runs, 10 * 500 + 3000);
  EXPECT_EQ(shares.front(), 1.0);
  EXPECT_EQ(shares.back(), 0.5);
}

// What is meant, with the hand's noise, cut at the line's ends and rounded as a slider rounds it.
TEST(MarkChance, IsThatOfDrawnMarks) {
  constexpr int kMarks = 200000;
  RandomStream stream(7, "marks");
  for (const double meant : {0.0, 0.03, 0.5, 1.0}) {
    std::vector<int> drawn(101);
    for (int i = 0; i < kMarks; ++i) {
      const double value = std::clamp(meant + 0.1 * draw_normal(stream), 0.0, 1.0);
      ++drawn[static_cast<std::size_t>(std::lround(100.0 * value))];
    }
    double sum = 0.0;
    for (int at = 0; at <= 100; ++at) {
      const double chance = mark_chance(Mark{0.01 * at}, meant, 0.1);
      const double share = static_cast<double>(drawn[static_cast<std::size_t>(at)]) / kMarks;
      EXPECT_NEAR(share, chance, 5.0 * std::sqrt(chance / kMarks) + 1e-5) << meant << " " << at;
      sum += chance;
    }
    EXPECT_NEAR(sum, 1.0, 1e-12);
  }
  EXPECT_GT(mark_chance(Mark{0.99}, 0.0, 0.1), 0.0);  // ten deviations off, and still some chance
}

TEST(MarkChance, AnywhereAnEndIsHalfAsProbableAsAPlaceBetween) {
  EXPECT_NEAR(mark_chance_anywhere(Mark{0.0}), 0.005, 1e-12);
  EXPECT_NEAR(mark_chance_anywhere(Mark{0.4}), 0.01, 1e-12);
  EXPECT_NEAR(mark_chance_anywhere(Mark{1.0, -1.0, 1.0}), 0.0025, 1e-12);
}

/// A clip that gets through by a distance, in degrees of heading: where the noise is as large, it
/// does in 84 % of runs.
Percept clip(double distance_deg) {
  return shares_by_noise(ImaginingParameters{}, 1,
                         [&](const Imagination& by, RandomStream& /*none*/) {
                           return normal_cdf(distance_deg / by.heading_noise_deg);
                         });
}

/// What people who imagine with a noise are asked for.
enum class Asked { kYesNo, kMark, kTwoSidedMark };

/// The answers of eight of them.
std::vector<AnsweringPerson> people_with(double noise_deg, Asked asked, std::uint64_t seed) {
  RandomStream stream(seed, "heading fit");
  std::vector<AnsweringPerson> people;
  for (int i = 0; i < 8; ++i) {
    people.push_back({"S" + std::to_string(i), {}});
    AnsweringPerson& person = people.back();
    for (double distance_deg = -4.0; distance_deg <= 4.0; distance_deg += 0.5) {
      AnsweredTrial& trial = person.trials.emplace_back();
      trial.percepts = {clip(distance_deg)};
      const double share = share_at_noise(trial.percepts[0], noise_deg);
      if (asked == Asked::kMark) {
        trial.mark = rounded_mark(std::clamp(share + 0.1 * draw_normal(stream), 0.0, 1.0));
      } else if (asked == Asked::kTwoSidedMark) {
        const double happened = i % 2;
        const Mark mark =
            rounded_mark(std::clamp(happened - share + 0.1 * draw_normal(stream), -1.0, 1.0));
        trial.mark = Mark{happened - mark.value, happened - 1.0, happened + 1.0};
      } else {
        trial.yes = stream.uniform() < 0.01 + 0.98 * share;
      }
    }
  }
  return people;
}

void expect_found(const ObserverFit& fit, double planted_deg) {
  const FittedParameter* noise = fit.find("heading_noise_deg");
  ASSERT_NE(noise, nullptr);
  ASSERT_TRUE(noise->is_fitted()) << noise->held_because;
  EXPECT_LT(noise->low, planted_deg);
  EXPECT_GT(noise->high, planted_deg);
  EXPECT_LT(noise->high - noise->low, planted_deg);
}

TEST(HeadingFit, FindsTheNoiseFromMarks) {
  const ObserverFile file = shipped_observer("two-balls");
  expect_found(fit_observer(*file.kind, *file.parameters, people_with(2.0, Asked::kMark, 1)), 2.0);
}

TEST(HeadingFit, FindsTheNoiseFromMarksWithTwoSides) {
  const ObserverFile file = shipped_observer("two-balls");
  const auto people = people_with(2.0, Asked::kTwoSidedMark, 3);
  expect_found(fit_observer(*file.kind, *file.parameters, people), 2.0);
}

TEST(HeadingFit, FindsTheNoiseFromYesAndNo) {
  const ObserverFile file = shipped_observer("what-will-happen");
  expect_found(fit_observer(*file.kind, *file.parameters, people_with(1.2, Asked::kYesNo, 2)), 1.2);
}

}  // namespace impetus::heading_fit_test
