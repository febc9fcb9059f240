// Thresholds planted in simulated participants come back, by constant stimuli and by QUEST+.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "experiments/design/adaptive_levels.hpp"
#include "experiments/files/protocol_files.hpp"
#include "tests/experiments/fitting/answering_group.hpp"

namespace impetus::planted_thresholds_test {

constexpr int kParticipants = 16;
constexpr double kWidth_ms = 45.0;
constexpr double kGuessRate = 0.03;
constexpr double kMissRate = 0.02;

/// The mean and standard error of estimated − planted over the participants.
struct Recovery {
  double bias{0.0};
  double standard_error{0.0};
};

Recovery recovery_of(const std::vector<double>& errors) {
  const auto count = static_cast<double>(errors.size());
  double mean = 0.0;
  for (const double error : errors) {
    mean += error / count;
  }
  double variance = 0.0;
  for (const double error : errors) {
    variance += (error - mean) * (error - mean) / (count - 1.0);
  }
  return {mean, std::sqrt(variance / count)};
}

/// Answers trials as a participant with this threshold, without anything being drawn or stepped.
class Answers {
 public:
  Answers(const Protocol& protocol, double threshold_ms, const std::string& pseudonym)
      : scene_(
            ProtocolScenes(protocol, 0.0).stage(cells(protocol.design).front(), assumed_screen())),
        observer_(make_observer(who_sees(threshold_ms), {7, pseudonym, clock_, clock_})) {}

  bool yes_to(double delay_ms) {
    observer_->witnessed(freeze(delay_ms), scene_);
    return observer_->ask(page_).choice == 0;
  }

 private:
  static ObserverFile who_sees(double threshold_ms) {
    return observer_with("causality", {{"threshold_mean_ms", threshold_ms},
                                       {"threshold_sd_ms", 0.0},
                                       {"threshold_width_ms", kWidth_ms},
                                       {"guess_rate", kGuessRate},
                                       {"miss_rate", kMissRate},
                                       {"effect_sd", 0.0}});
  }

  VirtualClock clock_;
  StagedScene scene_;
  std::unique_ptr<RatingObserver> observer_;
  Page page_{question_page("yes_no", 2)};
};

double delay_of(const PlannedTrial& trial) { return std::get<double>(trial.condition[0].value); }

/// From 80 to 155 ms.
double planted_ms(int participant) { return 80.0 + 5.0 * participant; }

/// How often yes and no were said to a delay.
struct Tally {
  double yes{0.0};
  double no{0.0};
};
using Tallies = std::map<double, Tally>;  ///< by delay (ms)

double log_likelihood(const Tallies& tallies, double threshold_ms, double width_ms) {
  double sum = 0.0;
  for (const auto& [delay_ms, tally] : tallies) {
    const double seen = normal_cdf((delay_ms - threshold_ms) / width_ms);
    const double yes = kGuessRate + (1.0 - kGuessRate - kMissRate) * seen;
    sum += tally.yes * std::log(yes) + tally.no * std::log(1.0 - yes);
  }
  return sum;
}

/// Maximum likelihood on a grid of thresholds and widths (the rates are known).
double fitted_threshold_ms(const Tallies& tallies) {
  double best = -1e300;
  double best_threshold_ms = 0.0;
  for (double threshold_ms = 10.0; threshold_ms <= 290.0; threshold_ms += 1.0) {
    for (double width_ms = 10.0; width_ms <= 120.0; width_ms += 5.0) {
      const double here = log_likelihood(tallies, threshold_ms, width_ms);
      if (here > best) {
        best = here;
        best_threshold_ms = threshold_ms;
      }
    }
  }
  return best_threshold_ms;
}

TEST(PlantedThreshold, ComesBackByConstantStimuliWithinTwoStandardErrors) {
  const Protocol protocol = load_protocol(source_file("protocols/causality-thresholds.json"));
  std::vector<double> errors;
  for (int participant = 0; participant < kParticipants; ++participant) {
    const std::string pseudonym = "S" + std::to_string(participant + 1);
    Answers answers(protocol, planted_ms(participant), pseudonym);
    Tallies tallies;
    for (const PlannedTrial& trial : make_plan(protocol.design, {protocol.name, pseudonym, 1})) {
      if (trial.phase == TrialPhase::kMain) {
        Tally& tally = tallies[delay_of(trial)];
        ++(answers.yes_to(delay_of(trial)) ? tally.yes : tally.no);
      }
    }
    ASSERT_EQ(tallies.size(), 7U);
    errors.push_back(fitted_threshold_ms(tallies) - planted_ms(participant));
  }
  const Recovery recovery = recovery_of(errors);
  EXPECT_LE(std::abs(recovery.bias), 2.0 * recovery.standard_error);
  EXPECT_LT(recovery.standard_error, 5.0);  // or anything would be within two of it
}

TEST(PlantedThreshold, ComesBackByQuestPlusWithinTwoStandardErrors) {
  const Protocol protocol = load_protocol(source_file("protocols/causality-thresholds-quest.json"));
  const std::size_t tracks = adaptive_tracks(protocol.design).size();
  std::vector<double> errors;
  for (int participant = 0; participant < kParticipants; ++participant) {
    const std::string pseudonym = "S" + std::to_string(participant + 1);
    Answers answers(protocol, planted_ms(participant), pseudonym);
    AdaptiveLevels levels(protocol.design);
    const Plan plan = make_plan(protocol.design, {protocol.name, pseudonym, 1});
    for (PlannedTrial trial : plan) {
      if (trial.track) {
        trial.condition = levels.choose(trial).condition;
        levels.take(trial, answers.yes_to(delay_of(trial)));
      }
    }
    double estimate_ms = 0.0;
    for (std::size_t track = 0; track < tracks; ++track) {
      PlannedTrial next = plan.back();
      next.track = static_cast<std::int64_t>(track);
      for (const FactorLevel& value : levels.choose(next).state) {
        estimate_ms += value.factor == "threshold"
                           ? std::get<double>(value.value) / static_cast<double>(tracks)
                           : 0.0;
      }
    }
    errors.push_back(estimate_ms - planted_ms(participant));
  }
  const Recovery recovery = recovery_of(errors);
  EXPECT_LE(std::abs(recovery.bias), 2.0 * recovery.standard_error);
  EXPECT_LT(recovery.standard_error, 5.0);
}

}  // namespace impetus::planted_thresholds_test
