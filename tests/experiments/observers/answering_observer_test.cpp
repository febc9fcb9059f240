// How the simulated participants answer yes or no and choose between two intervals.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "tests/experiments/asked_study.hpp"
#include "tests/experiments/fitting/answering_group.hpp"

namespace impetus::answering_observer_test {

/// Somebody of the causality study, like the mean of the group but for these numbers.
ObserverFile without_spread(std::map<std::string, double> numbers = {}) {
  numbers.insert({{"threshold_sd_ms", 0.0}, {"intercept_sd", 0.0}, {"lapse_rate", 0.0}});
  return observer_with("causality", numbers);
}

Page question(const std::string& response) { return question_page(response, 2); }

/// Shows a freeze of so many milliseconds in an interval.
void show(RatingObserver& observer, double delay_ms, std::int64_t interval) {
  AttemptRecord shown = freeze(delay_ms);
  shown.frames.resize(1);
  shown.frames[0].interval = interval;
  observer.witnessed(shown, two_balls());
}

/// Share of 4,000 answers that are the first choice; the delays of one interval or of two.
double share_of_first(const ObserverFile& file, const Page& page,
                      const std::vector<double>& delays_ms) {
  constexpr int kAnswers = 4000;
  VirtualClock clock;
  const auto observer = make_observer(file, {1, "S01", clock, clock});
  int first = 0;
  for (int i = 0; i < kAnswers; ++i) {
    std::int64_t interval = 0;
    for (const double delay_ms : delays_ms) {
      show(*observer, delay_ms, ++interval);
    }
    first += observer->ask(page).choice == 0 ? 1 : 0;
  }
  return static_cast<double>(first) / kAnswers;
}

constexpr double kFourErrors = 4.0 * 0.0079;  // √(.25 / 4000), at most

// P(yes) = γ + (1 − γ − λ) Φ((τ − 110) / 45)
TEST(AnsweringObserver, SaysYesAsOftenAsItSawSomething) {
  const ObserverFile file = without_spread({{"guess_rate", 0.1}, {"miss_rate", 0.05}});
  for (const double delay_ms : {0.0, 80.0, 110.0, 300.0}) {
    const double seen = 0.5 * std::erfc(-(delay_ms - 110.0) / 45.0 / std::sqrt(2.0));
    EXPECT_NEAR(share_of_first(file, question("yes_no"), {delay_ms}), 0.1 + 0.85 * seen,
                kFourErrors);
  }
}

TEST(AnsweringObserver, YesIsThePositiveChoiceWhereverItStands) {
  Page page = question("yes_no");
  page.positive_choice = 1;
  EXPECT_EQ(share_of_first(without_spread(), page, {1000.0}), 0.0);
}

// A high-threshold observer, enumerated: seen in the first alone, it is chosen; in both or neither,
// it is guessed.
TEST(AnsweringObserver, ChoosesOfTwoAsTheHighThresholdObserverDoes) {
  VirtualClock clock;
  const auto observer = make_observer(without_spread(), {1, "S01", clock, clock});
  for (double first = 0.0; first <= 1.0; first += 0.1) {
    for (double second = 0.0; second <= 1.0; second += 0.1) {
      double chosen = 0.0;
      for (const bool in_first : {false, true}) {
        for (const bool in_second : {false, true}) {
          const double chance =
              (in_first ? first : 1.0 - first) * (in_second ? second : 1.0 - second);
          chosen += chance * (in_first == in_second ? 0.5 : in_first ? 1.0 : 0.0);
        }
      }
      EXPECT_NEAR(observer->first_probability(first, second), chosen, 1e-12);
    }
  }
}

TEST(AnsweringObserver, ComparesWhatWasShownInTheTwoIntervalsOfTheSameTrial) {
  // No delay is 11 standard deviations below the threshold.
  const ObserverFile file = without_spread({{"threshold_width_ms", 10.0}});
  const Page page = question("two_interval");
  EXPECT_EQ(share_of_first(file, page, {1000.0, 0.0}), 1.0);
  EXPECT_EQ(share_of_first(file, page, {0.0, 1000.0}), 0.0);
  EXPECT_NEAR(share_of_first(file, page, {110.0, 0.0}), 0.75, kFourErrors);
  EXPECT_NEAR(share_of_first(file, page, {110.0, 110.0}), 0.5, kFourErrors);
  const ObserverFile lapsing = without_spread({{"threshold_width_ms", 10.0}, {"lapse_rate", 0.2}});
  EXPECT_NEAR(share_of_first(lapsing, page, {1000.0, 0.0}), 0.9, kFourErrors);
}

TEST(AnsweringObserver, GivesNoAnswerThatWouldComeAfterThePagesTime) {
  VirtualClock clock;
  const auto observer =
      make_observer(without_spread({{"reaction_median_ms", 1000.0}, {"reaction_sigma_log", 0.5}}),
                    {1, "S01", clock, clock});
  Page page = question("yes_no");
  page.timeout_ms = 1000.0;
  int timed_out = 0;
  for (int i = 0; i < 1000; ++i) {
    const Answer answer = observer->ask(page);
    const std::int64_t took_ns = answer.arrived_ns - answer.shown_ns;
    EXPECT_LE(took_ns, 1'000'000'000);
    EXPECT_EQ(answer.timed_out, took_ns == 1'000'000'000);
    EXPECT_EQ(answer.device, answer.timed_out ? "none" : "simulated");
    timed_out += answer.timed_out ? 1 : 0;
  }
  EXPECT_NEAR(timed_out, 500, 4 * 16);  // the median; √(1000 · ¼) = 16
}

TEST(AnsweringObserver, RatesOfGuessesAndMissesMayStandInItsFile) {
  const TemporaryFolder folder;
  json file = json::parse(shipped("experiments/observers/causality.json"));
  const auto loaded = [&]() -> RatingParameters {
    return *load_observer(folder.write("o.json", file.dump()).string(), "x").parameters;
  };
  EXPECT_EQ(loaded().yes_guess_rate, 0.0);
  file["parameters"]["guess_rate"] = {{"value", 0.03}, {"unit", "probability"}, {"source", "x"}};
  file["parameters"]["miss_rate"] = {{"value", 0.02}, {"unit", "probability"}, {"source", "x"}};
  EXPECT_EQ(loaded().yes_guess_rate, 0.03);
  EXPECT_EQ(loaded().yes_miss_rate, 0.02);
  file["parameters"]["miss_rate"]["value"] = 2;
  const std::string refused = refusal([&] { loaded(); });
  EXPECT_TRUE(
      refused.ends_with("o.json:/parameters/miss_rate/value: expected a number ≥ 0 and ≤ 1, got 2"))
      << refused;
}

}  // namespace impetus::answering_observer_test
