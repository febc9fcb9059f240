// The parameters of an observer that explain people's answers best, each with its interval.
//
//   1  what no answer depends on is held: the study does not ask it
//   2  maximum likelihood from several starts (minimum.hpp)
//   3  the likelihood's profile of each parameter: how far it can go, all others following, until
//      the answers are less probable by 1.92 in the logarithm: its 95 % interval
//   4  one whose profile never gets there is not identified: it is held at what the file assumed,
//      and the others are fitted again, until each has an interval
//
// Numbers that are held are part of what was assumed: intervals are given these.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "experiments/fitting/likelihood.hpp"

namespace impetus::inline fitting {

/// Why a parameter was held that the study does not ask.
inline constexpr const char* kNotAsked = "no answer of the study depends on it";

/// A parameter after a fit.
struct FittedParameter {
  std::string name;
  double value{0.0};
  double low{0.0};  ///< of its 95 % interval
  double high{0.0};
  std::string held_because{};  ///< "": it was fitted
  double assumed{0.0};         ///< where the fit began

  [[nodiscard]] bool is_fitted() const { return held_because.empty(); }
};

/// What a fit found.
struct ObserverFit {
  std::vector<FittedParameter> parameters;  ///< those that can be fitted, the most telling first
  double logarithm{0.0};                    ///< of the answers' probability
  std::shared_ptr<const RatingParameters> best{};

  /// Null: there is no such parameter.
  [[nodiscard]] const FittedParameter* find(const std::string& name) const;
  [[nodiscard]] std::size_t count() const;
};

/// How much of it is wanted.
struct FitWish {
  bool as_group{true};  ///< people differ; else all are alike, or there is one
  int starts{3};
  bool intervals{true};                    ///< else held is only what no answer depends on
  std::vector<std::string> only{};         ///< whose intervals are wanted; none: all
  std::function<void(double)> progress{};  ///< is told the share that is done
};

/// Fits. `start` is the kind's.
ObserverFit fit_observer(const ObserverKind& kind, const RatingParameters& start,
                         const std::vector<AnsweringPerson>& people, const FitWish& wish = {});

/// What is missing for a fit of this kind: "trials with ...", said after "expected"; none: nothing.
std::optional<std::string> missing_for_fit(const ObserverKind& kind,
                                           const std::vector<AnsweringPerson>& people);

}  // namespace impetus::inline fitting
