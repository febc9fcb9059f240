// SPDX-License-Identifier: MIT
#include "experiments/observers/causality_observer.hpp"
#include "experiments/observers/gap_observer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "experiments/protocol/observer_file.hpp"
#include "tests/experiments/fakes.hpp"

namespace impetus::observer_test {

CausalityParameters shipped() {
  const auto file = source_file("experiments/observers/causality.json").string();
  return static_cast<const CausalityParameters&>(*load_observer(file, "x").parameters);
}

GapParameters shipped_gap() {
  const auto file = source_file("experiments/observers/gap.json").string();
  return static_cast<const GapParameters&>(*load_observer(file, "x").parameters);
}

double mean_rating(const CausalityObserver& observer, double delay_ms) {
  const auto p = observer.rating_probabilities(delay_ms);
  return p[0] + 2.0 * p[1] + 3.0 * p[2];
}

TEST(CausalityObserver, ProbabilitiesAddUpToOne) {
  VirtualClock clock;
  const CausalityObserver observer(shipped(), {1, "S01", clock, clock});
  for (double delay_ms = 0.0; delay_ms <= 1000.0; delay_ms += 50.0) {
    const auto p = observer.rating_probabilities(delay_ms);
    EXPECT_NEAR(std::accumulate(p.begin(), p.end(), 0.0), 1.0, 1e-12);
  }
}

// Without spread between participants the model is a closed formula, here written out again.
TEST(CausalityObserver, IsTheStatedModel) {
  CausalityParameters parameters = shipped();
  parameters.threshold_sd_ms = 0.0;
  parameters.intercept_sd = 0.0;
  VirtualClock clock;
  const CausalityObserver observer(parameters, {1, "S01", clock, clock});
  // η = −2.2 + 4.5 Φ((110 − 110)/45) = 0.05; P(1) = .98 / (1 + e^(1.05)) + .02/3
  EXPECT_NEAR(observer.rating_probabilities(110.0)[0], 0.98 / (1.0 + std::exp(1.05)) + 0.02 / 3.0,
              1e-12);
}

TEST(CausalityObserver, MeanRatingsComeNearTheThesis) {
  VirtualClock clock;
  constexpr int kParticipants = 400;
  double mean[3] = {};
  for (int i = 0; i < kParticipants; ++i) {
    const CausalityObserver observer(shipped(), {1, "S" + std::to_string(i), clock, clock});
    for (int d = 0; d < 3; ++d) {
      const double delay_ms[] = {0.0, 100.0, 300.0};
      mean[d] += mean_rating(observer, delay_ms[d]) / kParticipants;
    }
  }
  // 1.3, 1.9 and 2.7 are stated to one digit as "about".
  EXPECT_NEAR(mean[0], 1.3, 0.1);
  EXPECT_NEAR(mean[1], 1.9, 0.1);
  EXPECT_NEAR(mean[2], 2.7, 0.1);
}

TEST(CausalityObserver, AnswersFollowFromSeedAndPseudonym) {
  const auto ratings = [](std::uint64_t seed, const std::string& name) {
    VirtualClock clock;
    CausalityObserver observer(shipped(), {seed, name, clock, clock});
    Page page;
    page.layout = Page::Layout::kScale;
    page.response = "rating";
    std::string text;
    for (int i = 0; i < 60; ++i) {
      text += std::to_string(observer.ask(page).choice);
    }
    return text;
  };
  EXPECT_EQ(ratings(1, "S01"), ratings(1, "S01"));
  EXPECT_NE(ratings(1, "S01"), ratings(2, "S01"));
  EXPECT_NE(ratings(1, "S01"), ratings(1, "S02"));
}

TEST(CausalityObserver, JudgesTheFreezeThatWasShown) {
  VirtualClock clock;
  CausalityParameters parameters = shipped();
  parameters.lapse_rate = 0.0;
  parameters.effect = 1e3;  // certain to rate 3 when the freeze is seen, 1 when it is not
  parameters.baseline = -500.0;
  CausalityObserver observer(parameters, {1, "S01", clock, clock});
  Page page;
  page.layout = Page::Layout::kScale;
  page.response = "rating";
  AttemptRecord shown;
  shown.collisions.resize(1);
  const StagedScene scene{World({}, {}, {}), {}, {}};
  observer.witnessed(shown, scene);
  EXPECT_EQ(observer.ask(page).choice, 0U);
  shown.collisions[0].report.imposed_hold_s = 1.0;
  observer.witnessed(shown, scene);
  EXPECT_EQ(observer.ask(page).choice, 2U);
}

/// Choices on sixty scales of `points`, of which `best` is the good end.
std::vector<std::size_t> choices(const CausalityParameters& parameters, std::size_t best) {
  VirtualClock clock;
  CausalityObserver observer(parameters, {1, "S01", clock, clock});
  Page page;
  page.layout = Page::Layout::kScale;
  page.response = "rating";
  page.best_choice = best;
  std::vector<std::size_t> choices(60);
  std::generate(choices.begin(), choices.end(), [&] { return observer.ask(page).choice; });
  return choices;
}

TEST(RatingObserver, CountsFromTheGoodEndWhicheverEndThatIs) {
  CausalityParameters parameters = shipped();
  parameters.cuts = {-3.0, -2.0, -1.5, 0.0};
  const auto lowest_best = choices(parameters, 0);
  const auto highest_best = choices(parameters, 4);
  for (std::size_t i = 0; i < lowest_best.size(); ++i) {
    EXPECT_EQ(highest_best[i], 4 - lowest_best[i]);
  }
  // Every point is drawn: each has a chance of .1 or more, so one is missed once in 500 seeds.
  EXPECT_EQ(std::set<std::size_t>(lowest_best.begin(), lowest_best.end()).size(), 5U);
}

// The model on more points, written out again: P(disbelief ≤ k) = logistic(cut_k − η), η =
// baseline.
TEST(RatingObserver, HasOnePointMoreThanCuts) {
  CausalityParameters parameters = shipped();
  parameters.threshold_sd_ms = parameters.intercept_sd = parameters.lapse_rate = 0.0;
  parameters.effect = 0.0;
  parameters.baseline = 0.5;
  parameters.cuts = {-1.0, 0.0, 1.0, 2.0};
  VirtualClock clock;
  const auto p = CausalityObserver(parameters, {1, "S01", clock, clock}).probabilities(0.7);
  const auto logistic = [](double x) { return 1.0 / (1.0 + std::exp(-x)); };
  ASSERT_EQ(p.size(), 5U);
  EXPECT_NEAR(p[0], logistic(-1.5), 1e-12);
  EXPECT_NEAR(p[2], logistic(0.5) - logistic(-0.5), 1e-12);
  EXPECT_NEAR(p[4], 1.0 - logistic(1.5), 1e-12);
}

// Recorded studies were answered by these draws: a change here would make them irreproducible.
TEST(RatingObserver, AnswersAsItDidWhenItWasFirstReleased) {
  std::string text;
  for (const std::size_t choice : choices(shipped(), 0)) {
    text += std::to_string(choice + 1);
  }
  EXPECT_EQ(text, "111121111121111111111111211111111111111211111111111111111131");
}

// Reddy's visible frequency at the values that the specification prints.
TEST(GapObserver, VisibleFrequencyIsAsPublished) {
  EXPECT_EQ(visible_frequency_at(0.0), 60.0);
  EXPECT_NEAR(visible_frequency_at(10.0), 29.91, 0.005);
  EXPECT_EQ(visible_frequency_at(200.0), 0.1);
}

TEST(GapObserver, HalfOfGapsAtTheThresholdAreSeenAndLargerOnesMore) {
  GapParameters parameters = shipped_gap();
  parameters.guess_rate = parameters.miss_rate = 0.0;
  VirtualClock clock;
  const GapObserver observer(parameters, {1, "S01", clock, clock});
  EXPECT_NEAR(observer.seen_gap(parameters.threshold_arcmin, 0.0, 0.5), 0.5, 1e-12);
  EXPECT_GT(observer.seen_gap(20.0, 0.0, 0.5), observer.seen_gap(10.0, 0.0, 0.5));
}

TEST(GapObserver, SpeedAndEccentricityHideAGap) {
  VirtualClock clock;
  const GapObserver observer(shipped_gap(), {1, "S01", clock, clock});
  EXPECT_LT(observer.seen_gap(15.0, 0.0, 30.0), observer.seen_gap(15.0, 0.0, 10.0));
  EXPECT_LT(observer.seen_gap(15.0, 5.0, 10.0), observer.seen_gap(15.0, 0.0, 10.0));
}

}  // namespace impetus::observer_test
