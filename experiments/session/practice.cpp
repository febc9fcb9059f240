// SPDX-License-Identifier: MIT
#include "experiments/session/practice.hpp"

#include <algorithm>

namespace impetus {
namespace {

/// What was done in the trials of one level of the rule's factor.
struct LevelTally {
  double ratings{0.0};
  std::int64_t clicks{0};
  std::int64_t trials{0};
};

LevelTally tally(const std::string& factor, const LevelValue& level,
                 const std::vector<PracticeResult>& round) {
  LevelTally tally;
  for (const PracticeResult& trial : round) {
    const bool counts = std::any_of(
        trial.condition.begin(), trial.condition.end(),
        [&](const FactorLevel& at) { return at.factor == factor && at.value == level; });
    if (counts) {
      tally.ratings += static_cast<double>(trial.rating);
      tally.clicks += trial.clicks;
      ++tally.trials;
    }
  }
  return tally;
}

}  // namespace

std::vector<std::string> missing_in_practice(const PracticeRule& rule, const Script& script,
                                             const std::vector<PracticeResult>& round) {
  const LevelTally best = tally(rule.factor, rule.best, round);
  const LevelTally worst = tally(rule.factor, rule.worst, round);
  std::vector<std::string> missing;
  if (script.clicks && worst.clicks == 0) {
    missing.emplace_back(
        "You did not click in the simulations in which every collision was bad. Please click as "
        "soon as you see a bad collision.");
  }
  const double best_mean = best.ratings / static_cast<double>(best.trials);
  const double worst_mean = worst.ratings / static_cast<double>(worst.trials);
  const bool high_is_good = script.scale.best == script.scale.maximum;
  if (high_is_good ? best_mean <= worst_mean : best_mean >= worst_mean) {
    missing.push_back("You did not rate the best simulations better than the worst. " +
                      std::to_string(script.scale.best) + " is for the best.");
  }
  return missing;
}

}  // namespace impetus
