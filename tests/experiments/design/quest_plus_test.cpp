// QUEST+ against the published examples of its paper, trial by trial, and against its definition.
// SPDX-License-Identifier: MIT
#include "experiments/design/quest_plus.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "engine/numerics/random_stream.hpp"
#include "experiments/design/psychometric.hpp"

namespace impetus::quest_plus_test {

using Function = QuestPlus::Function;
using Scale = QuestPlus::Scale;

/// The levels shown and the answers given in an example of Watson 2017; '1' is a correct one.
struct Example {
  std::vector<double> levels;
  std::string answers;
};

// "Estimation of contrast threshold"
const Example kThreshold{
    {-18, -22, -25, -28, -30, -22, -13, -15, -16, -18, -19, -20, -21, -22, -23, -19,
     -20, -20, -18, -18, -19, -17, -17, -18, -18, -18, -19, -19, -19, -19, -19, -19},
    "11110011111111011011011111111111"};

// "Implementation"
const Example kThresholdAndSlope{
    {-18, -22, -12, -13, -15, -16, -17, -18, -19, -21, -24, -25, -26, -27, -21, -22,
     -23, -20, -20, -20, -21, -19, -19, -20, -20, -20, -19, -19, -19, -19, -19, -20,
     -20, -20, -20, -20, -21, -21, -20, -20, -20, -19, -18, -18, -19, -19, -19, -18,
     -18, -17, -18, -18, -18, -17, -17, -17, -17, -17, -17, -17, -18, -18, -18, -18},
    "1011111111111011011101111011111111111011001111010111011111111111"};

// "Estimation of contrast threshold, slope, and lapse"
const Example kThresholdSlopeAndLapse{
    {-18, -22, -25, -28, -30, -21, -12, -14, -15, -16, -18, -19, -20, -22, -23, -18, -19, -16, -17,
     -17, -18, -18, -18, -19, -19, -17, -17, -18, -18, -18, -18, -19, -19, -20, -18, -18, -18, -18,
     -18, -19, -19, -19, -19, -20, -18, -18, -18, -18, -18, -18, -18, -18, -18, -19, -19, -19, -20,
     -18, -18, -18, -18, -19, -19, -19, -18, -18, -18, -18, -19, -19, -19, -19, -19, -19, -19, -19,
     -20, -21, -19, -19, -19, -19, -19, -19, -19, -18, -19, -19, -16, -16, -16, -16, -16, -16, 0,
     0,   -19, -19, -19, -19, -19, -19, -19, -19, -19, -19, -19, -19, -19, -19, -21, -21, -19, -19,
     -19, -19, -19, -19, -19, -19, -19, -19, -19, -19, -19, -19, -19, -19},
    "1111001111111101011111110111111110111111111011101111111101111110"
    "1111111111111010111101101111111011111111111111101110100111101111"};

// "Estimation of mean, standard deviation, and lapse"
const Example kMeanDeviationAndLapse{
    {0,  -1, 2,  -2, 2,  3,  3,  -5, 3,  3,  3,  3,  -7, -7, -7, -7, 4,  -7, 4,  4,  4,  -8,
     -8, -8, 4,  -8, 4,  -8, -7, 4,  -7, -7, 4,  -7, 4,  -7, -6, 3,  -4, -5, 3,  3,  -7, 2,
     2,  1,  0,  -7, -6, -6, -6, 2,  -5, 2,  -6, -5, 3,  -5, -5, 3,  4,  -5, -5, 4,  -4, -4,
     -4, -4, 4,  3,  3,  4,  5,  5,  -5, 5,  -5, -5, 4,  5,  5,  -5, -4, -4, -4, -4, 5,  -4,
     -4, -3, 4,  4,  5,  5,  -4, 5,  -4, -4, 5,  4,  5,  5,  -5, 5,  -4, -4, -4, -4, 5,  -4,
     5,  4,  -4, 4,  -4, -4, -4, 4,  -4, -4, -4, 4,  4,  -4, 4,  4,  4,  -4},
    "1001111111010000110110001010010010100101110111000001000010001001"
    "0001110011010001100000100110110101101101000011110100010000111110"};

std::vector<double> whole_numbers(int least, int most) {
  std::vector<double> numbers;
  for (int number = least; number <= most; ++number) {
    numbers.push_back(number);
  }
  return numbers;
}

/// Goes through an example; the levels must be those published. Returns the track at its end.
QuestPlusTrack reproduced(const Example& example, const std::vector<double>& places,
                          QuestPlusTrack track) {
  EXPECT_EQ(example.levels.size(), example.answers.size());
  for (std::size_t trial = 0; trial < example.levels.size(); ++trial) {
    const std::size_t level = track.level();
    EXPECT_EQ(places[level], example.levels[trial]) << "trial " << trial + 1;
    track.answer(level, example.answers[trial] == '1');
  }
  return track;
}

QuestPlusTrack contrast_track(const std::vector<double>& slopes,
                              const std::vector<double>& lapse_rates) {
  const QuestPlus method{Function::kWeibull, Scale::kDecibel, whole_numbers(-40, 0), slopes, {0.5},
                         lapse_rates};
  return QuestPlusTrack(std::make_shared<PsychometricTable>(
      method.function, method.scale, whole_numbers(-40, 0), candidates_of(method)));
}

TEST(QuestPlus, ReproducesThePublishedThresholdOfWatson2017TrialByTrial) {
  const QuestPlusTrack track =
      reproduced(kThreshold, whole_numbers(-40, 0), contrast_track({3.5}, {0.02}));
  EXPECT_EQ(track.mode().threshold, -20.0);
}

TEST(QuestPlus, ReproducesThePublishedThresholdAndSlopeOfWatson2017TrialByTrial) {
  const QuestPlusTrack track =
      reproduced(kThresholdAndSlope, whole_numbers(-40, 0), contrast_track({2, 3, 4, 5}, {0.02}));
  EXPECT_EQ(track.mode().threshold, -20.0);
  EXPECT_EQ(track.mode().slope, 3.0);
}

TEST(QuestPlus, ReproducesThePublishedThresholdSlopeAndLapseOfWatson2017TrialByTrial) {
  const QuestPlusTrack track =
      reproduced(kThresholdSlopeAndLapse, whole_numbers(-40, 0),
                 contrast_track({2, 3, 4, 5}, {0.0, 0.01, 0.02, 0.03, 0.04}));
  EXPECT_EQ(track.mode().threshold, -20.0);
  EXPECT_EQ(track.mode().slope, 5.0);
  EXPECT_EQ(track.mode().lapse_rate, 0.04);
}

// There the guess rate is the lapse rate: either end is missed as often.
TEST(QuestPlus, ReproducesThePublishedMeanDeviationAndLapseOfWatson2017TrialByTrial) {
  std::vector<PsychometricParameters> candidates;
  for (const double mean : whole_numbers(-5, 5)) {
    for (const double deviation : whole_numbers(1, 10)) {
      for (const double lapse : {0.0, 0.01, 0.02, 0.03, 0.04}) {
        candidates.push_back({mean, deviation, lapse, lapse});
      }
    }
  }
  const std::vector<double> places = whole_numbers(-10, 10);
  const QuestPlusTrack track =
      reproduced(kMeanDeviationAndLapse, places,
                 QuestPlusTrack(std::make_shared<PsychometricTable>(
                     Function::kNormal, Scale::kLinear, places, candidates)));
  EXPECT_EQ(track.mode().threshold, 0.0);
  EXPECT_EQ(track.mode().slope, 4.0);
  EXPECT_EQ(track.mode().lapse_rate, 0.01);
}

// ---------------------------------------------------------------- against the definition

/// Expected entropy by the book: a whole posterior for every level and answer, with the C
/// library's functions.
class ByTheBook {
 public:
  ByTheBook(const QuestPlus& method, std::vector<double> places)
      : method_(method),
        places_(std::move(places)),
        candidates_(candidates_of(method)),
        posterior_(candidates_.size(), 1.0 / static_cast<double>(candidates_.size())) {}

  [[nodiscard]] double expected_entropy(std::size_t level) const {
    double expected = 0.0;
    for (const bool positive : {true, false}) {
      const std::vector<double> joint = times_likelihood(level, positive);
      const double total = sum(joint);
      for (const double part : joint) {
        expected -= part > 0.0 ? part * std::log(part / total) : 0.0;
      }
    }
    return expected;
  }

  void answer(std::size_t level, bool positive) {
    posterior_ = times_likelihood(level, positive);
    const double total = sum(posterior_);
    for (double& probability : posterior_) {
      probability /= total;
    }
  }

 private:
  static double sum(const std::vector<double>& values) {
    double total = 0.0;
    for (const double value : values) {
      total += value;
    }
    return total;
  }

  [[nodiscard]] std::vector<double> times_likelihood(std::size_t level, bool positive) const {
    std::vector<double> joint;
    for (std::size_t i = 0; i < candidates_.size(); ++i) {
      const PsychometricParameters& p = candidates_[i];
      const double range = 1.0 - p.guess_rate - p.lapse_rate;
      const double z = (places_[level] - p.threshold) / p.slope;
      const double seen =
          method_.function == Function::kNormal
              ? 0.5 * std::erfc(-z / std::sqrt(2.0))
              : 1.0 - std::exp(-std::pow(10.0, p.slope * (places_[level] - p.threshold)));
      const double chance = p.guess_rate + range * seen;
      joint.push_back(posterior_[i] * (positive ? chance : 1.0 - chance));
    }
    return joint;
  }

  QuestPlus method_;
  std::vector<double> places_;
  std::vector<PsychometricParameters> candidates_;
  std::vector<double> posterior_;
};

TEST(QuestPlus, NoLevelLeavesLessExpectedEntropyByTheBookWhateverTheAnswers) {
  for (const Function function : {Function::kNormal, Function::kWeibull}) {
    const QuestPlus method{
        function,    function == Function::kNormal ? Scale::kLinear : Scale::kLog10,
        {1, 2.5, 4}, {0.5, 1.5},
        {0.0, 0.5},  {0.0, 0.02}};
    const std::vector<double> places{0, 1, 1.5, 2, 3, 4, 5};
    RandomStream random(11, "answers");
    ByTheBook book(method, places);
    QuestPlusTrack track(
        std::make_shared<PsychometricTable>(function, method.scale, places, candidates_of(method)));
    for (int trial = 0; trial < 60; ++trial) {
      const std::size_t chosen = track.level();
      for (std::size_t other = 0; other < places.size(); ++other) {
        ASSERT_LE(book.expected_entropy(chosen), book.expected_entropy(other) + 1e-12)
            << "trial " << trial << ", level " << other;
      }
      // Answers of someone whose threshold lies in the middle.
      const bool positive = random.uniform() < (places[chosen] > 2.5 ? 0.9 : 0.3);
      track.answer(chosen, positive);
      book.answer(chosen, positive);
    }
  }
}

TEST(QuestPlus, LevelsAreTakenToTheirScale) {
  EXPECT_EQ(on_scale(Scale::kLinear, 250.0), 250.0);
  EXPECT_NEAR(on_scale(Scale::kLog10, 250.0), std::log10(250.0), 1e-15);
  EXPECT_NEAR(on_scale(Scale::kDecibel, 250.0), 20.0 * std::log10(250.0), 1e-13);
}

// p = 1 − λ − (1 − γ − λ) exp(−1) at the threshold, on every scale.
TEST(QuestPlus, AWeibullFunctionIsTheSameOnEveryScale) {
  const double expected = 1.0 - 0.02 - 0.48 * std::exp(-1.0);
  for (const Scale scale : {Scale::kLinear, Scale::kLog10, Scale::kDecibel}) {
    const double threshold = on_scale(scale, 40.0);
    const double slope = 3.0;
    EXPECT_NEAR(
        positive_chance(Function::kWeibull, scale, threshold, {threshold, slope, 0.5, 0.02}),
        expected, 1e-14);
    // (80 / 40)³ = 8
    EXPECT_NEAR(positive_chance(Function::kWeibull, scale, on_scale(scale, 80.0),
                                {threshold, slope, 0.5, 0.02}),
                1.0 - 0.02 - 0.48 * std::exp(-8.0), 1e-14);
  }
  EXPECT_EQ(positive_chance(Function::kWeibull, Scale::kLinear, 0.0, {40.0, 3.0, 0.5, 0.02}), 0.5);
}

}  // namespace impetus::quest_plus_test
