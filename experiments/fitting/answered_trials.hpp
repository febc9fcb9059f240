// What people answered, and what an observer goes by in what they were shown: all that a fit needs.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "experiments/observers/answer_model.hpp"

namespace impetus::inline fitting {

/// A trial with its answers, those that its protocol asks for.
struct AnsweredTrial {
  std::vector<Percept> percepts;              ///< of each interval that was shown
  std::optional<std::size_t> rating_steps{};  ///< from the good end of the scale
  std::size_t rating_points{0};
  std::optional<bool> yes{};
  std::optional<bool> first{};                    ///< which of two intervals
  std::optional<Mark> mark{};                     ///< on a line
  std::optional<std::vector<double>> clicks_s{};  ///< from onset
  bool operator==(const AnsweredTrial&) const = default;
};

/// Somebody's trials.
struct AnsweringPerson {
  std::string code;
  std::vector<AnsweredTrial> trials;
};

/// How many trials all of them have.
inline std::size_t trials_of(const std::vector<AnsweringPerson>& people) {
  std::size_t trials = 0;
  for (const AnsweringPerson& person : people) {
    trials += person.trials.size();
  }
  return trials;
}

}  // namespace impetus::inline fitting
