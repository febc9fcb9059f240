// Fits of simulated groups: what was planted is found, within what the study tells.
// SPDX-License-Identifier: MIT
#include "experiments/fitting/fit.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/experiments/fitting/answering_group.hpp"

namespace impetus::fit_test {

const FittedParameter& found(const ObserverFit& fit, const std::string& name) {
  const FittedParameter* one = fit.find(name);
  EXPECT_NE(one, nullptr) << name;
  return *one;
}

PlantedStudy rated(PlantedStudy study) {
  study.question = "rating";
  study.points = 3;
  return study;
}

// ---------------------------------------------------------------- the likelihood

// Σ over points of P(point) = 1, for any traits.
TEST(AnswerLikelihood, ChancesOfAllAnswersAddUpToOne) {
  const ObserverFile file = shipped_observer("causality");
  const std::vector<AnsweringPerson> nobody{{"S1", {}}};
  AnswerLikelihood likelihood(*file.kind, *file.parameters, nobody, true);
  for (const double delay_ms : {0.0, 100.0, 300.0}) {
    AnsweredTrial trial{{{delay_ms}}};
    trial.rating_points = 3;
    double sum = 0.0;
    for (std::size_t steps = 0; steps < 3; ++steps) {
      trial.rating_steps = steps;
      sum += likelihood.chance(trial, {0.7, -1.1, 0.0});
    }
    EXPECT_NEAR(sum, 1.0, 1e-12);
  }
}

// log P = Σ log P(answer), where a participant has no traits: as the stated model says, written
// out again.
TEST(AnswerLikelihood, OfOnePersonIsTheStatedModel) {
  const ObserverFile file = shipped_observer("causality-thresholds");
  AnsweringPerson person{"S1", {}};
  for (const double delay_ms : {0.0, 100.0, 100.0, 200.0}) {
    person.trials.push_back({{{delay_ms}}});
    person.trials.back().yes = delay_ms == 100.0;
  }
  const std::vector<AnsweringPerson> people{person};
  const auto yes = [](double delay_ms) {
    return 0.03 + 0.95 * 0.5 * std::erfc(-(delay_ms - 110.0) / 45.0 / std::sqrt(2.0));
  };
  const double expected =
      std::log(1.0 - yes(0.0)) + 2.0 * std::log(yes(100.0)) + std::log(1.0 - yes(200.0));
  AnswerLikelihood likelihood(*file.kind, *file.parameters, people, false);
  EXPECT_NEAR(likelihood.logarithm(), expected, 1e-12);
}

/// log ∫∫ P(answers | z) φ(z) dz over threshold and intercept, by a dense grid.
double dense_logarithm(const AnswerLikelihood& likelihood, const AnsweringPerson& person) {
  constexpr double kThresholdStep = 0.02;
  constexpr double kInterceptStep = 0.1;
  double sum = 0.0;
  for (double threshold = -6.0; threshold <= 6.0; threshold += kThresholdStep) {
    for (double intercept = -6.0; intercept <= 6.0; intercept += kInterceptStep) {
      double chance = std::exp(-0.5 * (threshold * threshold + intercept * intercept)) /
                      (2.0 * 3.14159265358979) * kThresholdStep * kInterceptStep;
      for (const AnsweredTrial& trial : person.trials) {
        chance *= likelihood.chance(trial, {threshold, intercept, 0.0});
      }
      sum += chance;
    }
  }
  return std::log(sum);
}

/// The likelihood under `numbers` of three people who answered as the shipped observer.
/// `tolerance`: as far as the integral has settled, which it tells by its last halving.
void expect_dense(const std::map<std::string, double>& numbers, double tolerance) {
  const auto people = answering_group(shipped_observer("causality"),
                                      rated(delays_study(9, {0.0, 100.0, 300.0})), 3, /*seed=*/5);
  const ObserverFile file = observer_with("causality", numbers);
  AnswerLikelihood likelihood(*file.kind, *file.parameters, people, true);
  const std::vector<double> fast = likelihood.logarithms();
  for (std::size_t i = 0; i < people.size(); ++i) {
    EXPECT_NEAR(fast[i], dense_logarithm(likelihood, people[i]), tolerance) << "person " << i;
  }
}

TEST(AnswerLikelihood, OfAGroupIsTheIntegralOverTraits) { expect_dense({}, 5e-4); }

// A threshold that each knows within 8 ms, of people who differ by 80: several hills.
TEST(AnswerLikelihood, OfThresholdsThatAreStepsIsTheIntegralToo) {
  expect_dense({{"threshold_width_ms", 8.0}, {"threshold_sd_ms", 80.0}, {"intercept_sd", 1.5}},
               5e-3);
}

TEST(AnswerLikelihood, IsTheSameWhateverWasTriedBefore) {
  const ObserverFile file = shipped_observer("causality");
  const auto people =
      answering_group(file, rated(delays_study(9, {0.0, 100.0, 300.0})), 3, /*seed=*/5);
  AnswerLikelihood likelihood(*file.kind, *file.parameters, people, true);
  const double at_first = likelihood.logarithm();
  for (const MovableParameter& one : likelihood.movable()) {
    const double as_assumed = *one.place;
    *one.place = one.from_scale(one.on_scale(as_assumed) + 1.5);
    static_cast<void>(likelihood.logarithm());
    *one.place = as_assumed;
    EXPECT_EQ(likelihood.logarithm(), at_first) << one.name;
  }
}

// ---------------------------------------------------------------- fits

// Of 95 % intervals, 20 studies: fewer than 17 within has a probability of 1.6 %.
TEST(Fit, PlantedThresholdAndWidthAreWithinTheirIntervals) {
  const ObserverFile file = shipped_observer("causality-thresholds");
  constexpr int kStudies = 20;
  int thresholds = 0;
  int widths = 0;
  for (int study = 1; study <= kStudies; ++study) {
    const auto people = answering_group(file, delays_study(8), 16, /*seed=*/100 + study);
    const ObserverFit fit =
        fit_observer(*file.kind, *file.parameters, people,
                     {.starts = 1, .only = {"threshold_mean_ms", "threshold_width_ms"}});
    const FittedParameter& threshold = found(fit, "threshold_mean_ms");
    const FittedParameter& width = found(fit, "threshold_width_ms");
    thresholds += threshold.low <= 110.0 && 110.0 <= threshold.high ? 1 : 0;
    widths += width.low <= 45.0 && 45.0 <= width.high ? 1 : 0;
  }
  EXPECT_GE(thresholds, 17);
  EXPECT_GE(widths, 17);
}

// Of 95 % intervals, 8 studies: fewer than 6 within has a probability of .6 %.
TEST(Fit, FindsWhatIsPlantedFarFromWhereItBegins) {
  const ObserverFile file =
      observer_with("gap-thresholds", {{"threshold_arcmin", 22.0}, {"width_log10", 0.1}});
  const ObserverFile assumed = shipped_observer("gap-thresholds");
  int thresholds = 0;
  int widths = 0;
  for (const std::uint64_t seed : {1, 2, 3, 4, 5, 6, 7, 8}) {
    const auto people = answering_group(file, gaps_study(6), 10, seed);
    const ObserverFit fit =
        fit_observer(*assumed.kind, *assumed.parameters, people,
                     {.starts = 1, .only = {"threshold_arcmin", "width_log10"}});
    const FittedParameter& threshold = found(fit, "threshold_arcmin");
    const FittedParameter& width = found(fit, "width_log10");
    thresholds += threshold.low <= 22.0 && 22.0 <= threshold.high ? 1 : 0;
    widths += width.low <= 0.1 && 0.1 <= width.high ? 1 : 0;
    EXPECT_LT(threshold.high / threshold.low, 1.5);
    EXPECT_LT(width.high, 0.2);
  }
  EXPECT_GE(thresholds, 6);
  EXPECT_GE(widths, 6);
}

TEST(Fit, WhatNoAnswerDependsOnIsHeldAndSaidSo) {
  const ObserverFile file = shipped_observer("causality-thresholds");
  const auto people = answering_group(file, delays_study(6), 6, /*seed=*/2);
  const ObserverFit fit = fit_observer(*file.kind, *file.parameters, people, {.starts = 1});
  for (const char* name : {"effect", "cut_1_2", "cut_2_3", "intercept_sd", "lapse_rate"}) {
    EXPECT_EQ(found(fit, name).held_because, "no answer of the study depends on it") << name;
  }
  EXPECT_EQ(found(fit, "effect").value, 4.5);
  EXPECT_TRUE(found(fit, "threshold_mean_ms").is_fitted());
}

// Delays too short to be seen: nothing says how long one has to be.
TEST(Fit, WhatTheDesignDoesNotIdentifyIsHeldAndSaidSo) {
  const ObserverFile file = shipped_observer("causality-thresholds");
  const auto person = answering_person(file, delays_study(60, {0.0, 10.0}), /*seed=*/2, "S1");
  const ObserverFit fit = fit_observer(*file.kind, *file.parameters, {person}, {.as_group = false});
  int held = 0;
  for (const FittedParameter& one : fit.parameters) {
    if (one.held_because == "the study does not identify it") {
      ++held;
      EXPECT_EQ(one.value, number_in(file.document, one.name)) << one.name;
    }
  }
  EXPECT_GE(held, 1);
}

TEST(Fit, AStudyThatIdentifiesNothingLeavesAllAsAssumed) {
  const ObserverFile file = shipped_observer("causality-thresholds");
  PlantedStudy study;
  study.question = "two_interval";
  study.trials = {{freeze(0.0), freeze(10.0)}, {freeze(10.0), freeze(0.0)}};
  const auto person = answering_person(file, study, /*seed=*/1, "S1");
  const ObserverFit fit = fit_observer(*file.kind, *file.parameters, {person}, {.as_group = false});
  EXPECT_EQ(fit.count(), 0U);
}

TEST(Fit, MarksOnALineTellThresholdWidthAndTheirOwnNoise) {
  const ObserverFile file = shipped_observer("odd-shapes");
  PlantedStudy study = gaps_study(2);
  study.question = "slider";
  const ObserverFit fit =
      fit_observer(*file.kind, *file.parameters, answering_group(file, study, 8, /*seed=*/3));
  for (const auto& [name, planted] :
       {std::pair{"gap_threshold_arcmin", 36.0}, {"gap_width_arcmin", 20.0}, {"mark_sd", 0.12}}) {
    const FittedParameter& one = found(fit, name);
    ASSERT_TRUE(one.is_fitted()) << name;
    EXPECT_LT(one.low, planted) << name;
    EXPECT_GT(one.high, planted) << name;
    EXPECT_LT(one.high - one.low, 0.6 * planted) << name;
  }
  EXPECT_FALSE(found(fit, "delay_threshold_ms").is_fitted()) << "nothing was late";
}

// People differ in a threshold, which moves what is most probable of them; what only ratings go by
// is held all the same.
TEST(Fit, OfMarksAloneLooksForNothingThatRatingsGoBy) {
  const ObserverFile file = shipped_observer("odd-shapes");
  PlantedStudy study = delays_study(20, {33.3, 66.7});
  study.question = "slider";
  const auto people = answering_group(file, study, 6, /*seed=*/4);
  const ObserverFit fit =
      fit_observer(*file.kind, *file.parameters, people, {.starts = 1, .intervals = false});
  for (const char* name : {"effect", "cut_1_2", "lapse_rate", "intercept_sd"}) {
    EXPECT_EQ(found(fit, name).held_because, kNotAsked) << name;
  }
  EXPECT_TRUE(found(fit, "delay_threshold_ms").is_fitted());
  EXPECT_TRUE(found(fit, "delay_threshold_sd_ms").is_fitted());
}

TEST(Fit, IsTheSameEachTime) {
  const ObserverFile file = shipped_observer("causality-thresholds");
  const auto people = answering_group(file, delays_study(5), 5, /*seed=*/9);
  const ObserverFit once = fit_observer(*file.kind, *file.parameters, people);
  const ObserverFit again = fit_observer(*file.kind, *file.parameters, people);
  ASSERT_EQ(once.parameters.size(), again.parameters.size());
  for (std::size_t i = 0; i < once.parameters.size(); ++i) {
    EXPECT_EQ(once.parameters[i].value, again.parameters[i].value);
    EXPECT_EQ(once.parameters[i].low, again.parameters[i].low);
    EXPECT_EQ(once.parameters[i].high, again.parameters[i].high);
  }
}

// ---------------------------------------------------------------- what cannot be fitted

TEST(Fit, SaysWhatIsMissing) {
  const ObserverFile file = shipped_observer("causality-thresholds");
  EXPECT_EQ(missing_for_fit(*file.kind, {}),
            "completed trials with answers that such a participant gives and that can be fitted "
            "(a rating, yes or no, a choice of two intervals), got none");
  AnsweringPerson person{"S1", {}};
  for (int i = 0; i < 3; ++i) {
    person.trials.push_back({{{100.0}}});
    person.trials.back().yes = i == 0;
  }
  EXPECT_EQ(missing_for_fit(*file.kind, {person}),
            "trials that differ in what the observer looks at (the delay at contact), got 3 trials "
            "in which it is the same");
  person.trials[0].percepts[0][0] = 0.0;
  person.trials[0].yes = false;
  EXPECT_EQ(missing_for_fit(*file.kind, {person}),
            "answers that differ, got 3 trials with the same one");
  person.trials[0].yes = true;
  EXPECT_EQ(missing_for_fit(*file.kind, {person}), std::nullopt);
}

}  // namespace impetus::fit_test
