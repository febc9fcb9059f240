// SPDX-License-Identifier: MIT
#include "experiments/session/intervals.hpp"

#include "engine/numerics/random_stream.hpp"

namespace impetus::inline session {

Condition standard_of(const Condition& condition, const TwoIntervalQuestion& question) {
  Condition standard = condition;
  for (FactorLevel& level : standard) {
    for (const FactorLevel& replacement : question.standard) {
      if (replacement.factor == level.factor) {
        level.value = replacement.value;
      }
    }
  }
  return standard;
}

std::int64_t test_interval(const Script& script, const PlannedTrial& trial) {
  if (!script.two_interval) {
    return 1;
  }
  RandomStream order(trial.seed, "order of intervals");
  return 1 + static_cast<std::int64_t>(order.below(2));
}

std::vector<PlannedTrial> stimuli_of(const Script& script, const PlannedTrial& trial) {
  if (!script.two_interval) {
    return {trial};
  }
  PlannedTrial standard = trial;
  standard.condition = standard_of(trial.condition, *script.two_interval);
  return test_interval(script, trial) == 1 ? std::vector<PlannedTrial>{trial, standard}
                                           : std::vector<PlannedTrial>{standard, trial};
}

}  // namespace impetus::inline session
