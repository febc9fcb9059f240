// Which of several observers foretells best what people answer whom it was not fitted to.
//
//   people in folds:   fit all but one fold ─> the logarithm of the fold's probability   for each
//
// With one person the folds are of trials. One of the observers goes by nothing that was shown: to
// be chosen is to foretell better than it, by more than chance may: by 1, and by Student's t
// (97.5 %) times the standard error of the difference over people, or over one person's trials.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "experiments/fitting/fit.hpp"

namespace impetus::inline fitting {

/// An observer that is compared, and the answers with its own percepts.
struct ComparedObserver {
  std::string name;
  const ObserverKind* kind{nullptr};
  std::shared_ptr<const RatingParameters> start{};
  std::vector<AnsweringPerson> people;
};

/// How well it foretold.
struct Foretelling {
  std::string name;
  /// The logarithm of the probability of each person's answers; of one person: of each trial's.
  std::vector<double> parts;
  double per_trial{0.0};  ///< of all
  double gain{0.0};       ///< the sum of the parts, less that of the observer that goes by nothing
  /// As much of it may be chance: t (97.5 %) standard errors over the parts, and at least 1.
  double gain_by_chance{0.0};
};

/// What a comparison found.
struct ObserverComparison {
  std::vector<Foretelling> observers;         ///< as they were given; the last goes by nothing
  std::optional<std::size_t> chosen{};        ///< none: none foretells better than that one
  std::vector<std::size_t> not_told_apart{};  ///< from the chosen one, by the same standard
  std::size_t folds{0};
};

/// The name of the observer that goes by nothing that was shown.
inline constexpr const char* kGoesByNothing = "none (goes by nothing that was shown)";

/// All must have the same people with the same trials. At most `most_folds` folds; `progress` is
/// told the share that is done.
ObserverComparison compare_observers(const std::vector<ComparedObserver>& observers,
                                     std::size_t most_folds,
                                     const std::function<void(double)>& progress = {});

}  // namespace impetus::inline fitting
