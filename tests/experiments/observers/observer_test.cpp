// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "experiments/observers/gap_observer.hpp"
#include "tests/experiments/fitting/answering_group.hpp"

namespace impetus::observer_test {

/// A participant and the clock that he lives by.
struct Someone {
  explicit Someone(const ObserverFile& file, const std::string& name = "S01",
                   std::uint64_t seed = 1)
      : self(make_observer(file, {seed, name, clock, clock})) {}

  /// The chance of each rating, from the good end on, of a freeze.
  std::vector<double> ratings(double delay_ms) {
    self->witnessed(freeze(delay_ms), two_balls());
    return self->probabilities(self->clearest());
  }

  VirtualClock clock;
  std::unique_ptr<RatingObserver> self;
};

Page scale(std::size_t best = 0) {
  Page page;
  page.layout = Page::Layout::kScale;
  page.response = "rating";
  page.best_choice = best;
  return page;
}

TEST(CausalityObserver, ProbabilitiesAddUpToOne) {
  Someone someone(shipped_observer("causality"));
  for (double delay_ms = 0.0; delay_ms <= 1000.0; delay_ms += 50.0) {
    const auto p = someone.ratings(delay_ms);
    EXPECT_NEAR(std::accumulate(p.begin(), p.end(), 0.0), 1.0, 1e-12);
  }
}

// Without spread between participants the model is a closed formula, here written out again.
TEST(CausalityObserver, IsTheStatedModel) {
  Someone someone(observer_with("causality", {{"threshold_sd_ms", 0.0}, {"intercept_sd", 0.0}}));
  // η = −2.2 + 4.5 Φ((110 − 110)/45) = 0.05; P(1) = .98 / (1 + e^(1.05)) + .02/3
  EXPECT_NEAR(someone.ratings(110.0)[0], 0.98 / (1.0 + std::exp(1.05)) + 0.02 / 3.0, 1e-12);
}

TEST(CausalityObserver, MeanRatingsComeNearTheThesis) {
  const ObserverFile file = shipped_observer("causality");
  constexpr int kParticipants = 400;
  double mean[3] = {};
  for (int i = 0; i < kParticipants; ++i) {
    Someone someone(file, "S" + std::to_string(i));
    for (int d = 0; d < 3; ++d) {
      const double delay_ms[] = {0.0, 100.0, 300.0};
      const auto p = someone.ratings(delay_ms[d]);
      mean[d] += (p[0] + 2.0 * p[1] + 3.0 * p[2]) / kParticipants;
    }
  }
  // 1.3, 1.9 and 2.7 are stated to one digit as "about".
  EXPECT_NEAR(mean[0], 1.3, 0.1);
  EXPECT_NEAR(mean[1], 1.9, 0.1);
  EXPECT_NEAR(mean[2], 2.7, 0.1);
}

TEST(CausalityObserver, AnswersFollowFromSeedAndPseudonym) {
  const auto ratings = [](std::uint64_t seed, const std::string& name) {
    Someone someone(shipped_observer("causality"), name, seed);
    std::string text;
    for (int i = 0; i < 60; ++i) {
      text += std::to_string(someone.self->ask(scale()).choice);
    }
    return text;
  };
  EXPECT_EQ(ratings(1, "S01"), ratings(1, "S01"));
  EXPECT_NE(ratings(1, "S01"), ratings(2, "S01"));
  EXPECT_NE(ratings(1, "S01"), ratings(1, "S02"));
}

TEST(CausalityObserver, JudgesTheFreezeThatWasShown) {
  // Certain to rate 3 when the freeze is seen, 1 when it is not.
  Someone someone(
      observer_with("causality", {{"lapse_rate", 0.0}, {"effect", 1e3}, {"baseline", -500.0}}));
  someone.self->witnessed(freeze(0.0), two_balls());
  EXPECT_EQ(someone.self->ask(scale()).choice, 0U);
  someone.self->witnessed(freeze(1000.0), two_balls());
  EXPECT_EQ(someone.self->ask(scale()).choice, 2U);
}

/// Choices on sixty scales of `points`, of which `best` is the good end.
std::vector<std::size_t> choices(const ObserverFile& file, std::size_t best) {
  Someone someone(file);
  std::vector<std::size_t> choices(60);
  std::generate(choices.begin(), choices.end(),
                [&] { return someone.self->ask(scale(best)).choice; });
  return choices;
}

TEST(RatingObserver, CountsFromTheGoodEndWhicheverEndThatIs) {
  const ObserverFile file = observer_with(
      "causality", {{"cut_1_2", -3.0}, {"cut_2_3", -2.0}, {"cut_3_4", -1.5}, {"cut_4_5", 0.0}});
  const auto lowest_best = choices(file, 0);
  const auto highest_best = choices(file, 4);
  for (std::size_t i = 0; i < lowest_best.size(); ++i) {
    EXPECT_EQ(highest_best[i], 4 - lowest_best[i]);
  }
  // Every point is drawn: each has a chance of .1 or more, so one is missed once in 500 seeds.
  EXPECT_EQ(std::set<std::size_t>(lowest_best.begin(), lowest_best.end()).size(), 5U);
}

// The model on more points, written out again: P(disbelief ≤ k) = logistic(cut_k − η), η =
// baseline.
TEST(RatingObserver, HasOnePointMoreThanCuts) {
  const Someone someone(observer_with("causality", {{"threshold_sd_ms", 0.0},
                                                    {"intercept_sd", 0.0},
                                                    {"lapse_rate", 0.0},
                                                    {"effect", 0.0},
                                                    {"baseline", 0.5},
                                                    {"cut_1_2", -1.0},
                                                    {"cut_2_3", 0.0},
                                                    {"cut_3_4", 1.0},
                                                    {"cut_4_5", 2.0}}));
  const auto p = someone.self->probabilities(0.7);
  const auto logistic = [](double x) { return 1.0 / (1.0 + std::exp(-x)); };
  ASSERT_EQ(p.size(), 5U);
  EXPECT_NEAR(p[0], logistic(-1.5), 1e-12);
  EXPECT_NEAR(p[2], logistic(0.5) - logistic(-0.5), 1e-12);
  EXPECT_NEAR(p[4], 1.0 - logistic(1.5), 1e-12);
}

// Recorded studies were answered by these draws: a change here would make them irreproducible.
TEST(RatingObserver, AnswersAsItDidWhenItWasFirstReleased) {
  std::string text;
  for (const std::size_t choice : choices(shipped_observer("causality"), 0)) {
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

/// How clearly one gap is seen, of two bodies.
double seen_gap(const ObserverFile& file, double visible_arcmin, double eccentricity_deg,
                double speed_deg_s) {
  return file.kind->answers.seen(*file.parameters, {},
                                 {2.0, visible_arcmin, eccentricity_deg, speed_deg_s});
}

TEST(GapObserver, HalfOfGapsAtTheThresholdAreSeenAndLargerOnesMore) {
  const ObserverFile file = observer_with("gap", {{"guess_rate", 0.0}, {"miss_rate", 0.0}});
  const double threshold_arcmin = number_in(file.document, "threshold_arcmin");
  EXPECT_NEAR(seen_gap(file, threshold_arcmin, 0.0, 0.5), 0.5, 1e-12);
  EXPECT_GT(seen_gap(file, 20.0, 0.0, 0.5), seen_gap(file, 10.0, 0.0, 0.5));
}

TEST(GapObserver, SpeedAndEccentricityHideAGap) {
  const ObserverFile file = shipped_observer("gap");
  EXPECT_LT(seen_gap(file, 15.0, 0.0, 30.0), seen_gap(file, 15.0, 0.0, 10.0));
  EXPECT_LT(seen_gap(file, 15.0, 5.0, 10.0), seen_gap(file, 15.0, 0.0, 10.0));
}

}  // namespace impetus::observer_test
