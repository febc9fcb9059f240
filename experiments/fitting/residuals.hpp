// What people answered beside what a fitted observer expects, in groups of trials.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "experiments/fitting/likelihood.hpp"

namespace impetus::inline fitting {

/// Trials for which much the same was expected.
struct ResidualGroup {
  double expected_from{0.0};
  double expected_to{0.0};
  std::size_t trials{0};
  double expected{0.0};  ///< mean
  double answered{0.0};  ///< mean
  double z{0.0};         ///< of the difference, by the variance that is expected
};

/// The residuals of one question.
struct QuestionResiduals {
  std::string question;  ///< "rating (steps from the good end)", "share of yes"
  std::vector<ResidualGroup> groups;
};

/// In up to `groups` groups of equal size by what is expected of each trial, for a participant with
/// the traits that explain them best. `likelihood` is of these people.
std::vector<QuestionResiduals> residuals(AnswerLikelihood& likelihood,
                                         const std::vector<AnsweringPerson>& people,
                                         std::size_t groups = 8);

}  // namespace impetus::inline fitting
