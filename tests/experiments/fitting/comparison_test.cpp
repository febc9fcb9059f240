// Observers compared by what they foretell.
// SPDX-License-Identifier: MIT
#include "experiments/fitting/comparison.hpp"

#include <gtest/gtest.h>

#include "tests/experiments/fitting/answering_group.hpp"

namespace impetus::comparison_test {

/// The shipped participant of the study of thresholds, but for some of its numbers.
ObserverFile participant(const std::vector<std::pair<std::string, double>>& numbers = {}) {
  ObserverFile file = shipped_observer("causality-thresholds");
  for (const auto& [name, value] : numbers) {
    file.document.value["parameters"][name]["value"] = value;
  }
  file.parameters = file.kind->read(file.document);
  return file;
}

/// One observer that goes by the delay, and one that takes it for something else: delays in the
/// reverse order.
std::vector<ComparedObserver> two_observers(const std::vector<AnsweringPerson>& people) {
  const ObserverFile file = participant();
  std::vector<AnsweringPerson> reversed = people;
  for (AnsweringPerson& person : reversed) {
    for (AnsweredTrial& trial : person.trials) {
      trial.percepts[0][0] = 300.0 - trial.percepts[0][0];
    }
  }
  return {{"by the reverse", file.kind, file.parameters, reversed},
          {"by the delay", file.kind, file.parameters, people}};
}

TEST(ObserverComparison, ChoosesTheOneThatAnswered) {
  const auto people = answering_group(participant(), delays_study(6), 8, /*seed=*/4);
  const ObserverComparison comparison = compare_observers(two_observers(people), 4);
  ASSERT_TRUE(comparison.chosen);
  EXPECT_EQ(comparison.observers[*comparison.chosen].name, "by the delay");
  EXPECT_TRUE(comparison.not_told_apart.empty());
  EXPECT_EQ(comparison.folds, 4U);
}

// Nobody sees anything: half of the answers are yes, whatever was shown. One of two observers is
// chosen in some 5 % of studies: more than 1 of 8 has a probability of 6 %.
TEST(ObserverComparison, NullDataChooseNone) {
  const ObserverFile blind = participant({{"guess_rate", 0.5}, {"miss_rate", 0.499}});
  int chosen = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const auto people = answering_group(blind, delays_study(6), 8, seed);
    chosen += compare_observers(two_observers(people), 4).chosen ? 1 : 0;
  }
  EXPECT_LE(chosen, 1);
}

TEST(ObserverComparison, OfOnePersonHoldsOutTrials) {
  const auto person = answering_group(participant(), delays_study(20), 1, /*seed=*/4);
  const ObserverComparison comparison = compare_observers(two_observers(person), 5);
  ASSERT_TRUE(comparison.chosen);
  EXPECT_EQ(comparison.observers[*comparison.chosen].name, "by the delay");
  EXPECT_EQ(comparison.observers[0].parts.size(), person.front().trials.size());
}

}  // namespace impetus::comparison_test
