// What a fit found, as a participant file and as a page of Markdown beside it.
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "experiments/commands/fitting/posterior.hpp"
#include "experiments/fitting/comparison.hpp"
#include "experiments/fitting/residuals.hpp"
#include "experiments/protocol/observer_file.hpp"

namespace impetus::inline commands {

/// A person who was fitted alone.
struct PersonFit {
  std::string code;
  std::size_t trials{0};
  ObserverFit fit;
};

/// The mean of a parameter over people who were fitted one by one.
struct GroupMean {
  std::string name;
  std::size_t people{0};  ///< whose answers identify it
  double mean{0.0};
  double low{0.0};  ///< of its 95 % interval, by Student's t
  double high{0.0};
  double spread{0.0};  ///< standard deviation over people, the error of each fit included
};

/// All that is told of a fit.
struct FitStory {
  std::string study;
  std::string study_hash;
  std::string protocol;
  bool all_simulated{false};
  std::size_t simulated_left_out{0};
  std::string observer;  ///< its file
  std::string kind;
  std::size_t people{0};
  std::size_t trials{0};
  ObserverFit fit;  ///< of the group, or of the one person
  std::vector<PersonFit> by_person{};
  std::vector<GroupMean> means{};
  std::vector<QuestionResiduals> residuals{};
  std::optional<Posterior> posterior{};
  std::optional<ObserverComparison> comparison{};
};

/// "fitted to study.sqlite (0123…), 20 people"
std::string fitted_words(const FitStory& story);

/// The participant's file: `assumed` with what was fitted in place of what was assumed.
nlohmann::ordered_json fitted_document(const JsonDocument& assumed, const FitStory& story);

/// The page.
std::string fit_page(const FitStory& story);

/// What was fitted, for the terminal.
std::vector<std::vector<std::string>> parameter_rows(const FitStory& story);

/// What a comparison chose, in a sentence.
std::string choice_sentence(const ObserverComparison& comparison);

}  // namespace impetus::inline commands
