// How probable people's answers are under the parameters of a kind of observer.
//
//   one person     Σ over trials of log P(answers | percept, parameters, traits)
//   a group        Σ over people of log ∫ P(answers of one | traits) φ(traits) d traits
//
// Traits (a participant's threshold, intercept, slope) are standard normal: their spreads are
// parameters. Each person's integral is taken about the traits that explain that person best.
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "experiments/fitting/answered_trials.hpp"
#include "experiments/observers/observer_kinds.hpp"

namespace impetus::inline fitting {

/// A parameter that may be moved, and the scale on which that is done: numbers as they are in steps
/// of `unit`, what is positive by its logarithm, a probability by its logit.
struct MovableParameter {
  /// In what it is moved.
  enum class Scale { kLinear, kLog, kShare };

  std::string name;
  double* place{nullptr};
  Scale scale{Scale::kLinear};
  double unit{1.0};
  bool ends_at_zero{false};  ///< 0 is a value like others: nobody lapses, all are alike, a step
  double least{0.0};         ///< that a file may say

  [[nodiscard]] double on_scale(double value) const;
  [[nodiscard]] double from_scale(double x) const;
  /// How far on the scale is as good as infinitely far.
  [[nodiscard]] double reach() const { return scale == Scale::kLinear ? 60.0 : 12.0; }
};

/// A group's answers under one kind of observer, whose parameters it moves.
class AnswerLikelihood {
 public:
  /// `people` must outlive this. With `as_group` people differ by their traits; otherwise all are
  /// the mean.
  AnswerLikelihood(const ObserverKind& kind, const RatingParameters& start,
                   const std::vector<AnsweringPerson>& people, bool as_group);
  AnswerLikelihood(const AnswerLikelihood&) = delete;
  AnswerLikelihood& operator=(const AnswerLikelihood&) = delete;

  /// Parameters that a fit looks for, the most telling first. A spread that is 0 at the start stays
  /// so: that people differ in it is no part of this observer.
  [[nodiscard]] const std::vector<MovableParameter>& movable() const { return movable_; }

  /// From now on people do not differ in the trait of this spread, on which no answer depends.
  void forget_trait(const std::string& spread);

  /// The logarithm of the answers' probability under the parameters as they are; −∞ where these
  /// cannot be.
  [[nodiscard]] double logarithm();
  /// Of each person.
  [[nodiscard]] std::vector<double> logarithms();

  [[nodiscard]] const RatingParameters& parameters() const { return *parameters_; }
  /// The same, to be kept.
  [[nodiscard]] std::shared_ptr<const RatingParameters> copy() const {
    return model_->copy(*parameters_);
  }
  /// The chance of a trial's answers for a participant with these traits.
  [[nodiscard]] double chance(const AnsweredTrial& trial, const Traits& traits) const;
  /// The traits that explain a person best.
  [[nodiscard]] std::vector<Traits> likely_traits();

 private:
  /// A point of a scale that somebody gave, had he seen so much.
  struct GivenRating {
    double seen;
    std::size_t steps;
    std::size_t points;
    double chance{0.0};  ///< for the traits that were tried last
  };
  /// What may have been seen in a trial, and how probable that and all answers but the rating are.
  struct RatedOutcome {
    double chance;
    std::size_t rating;  ///< of the person's
  };
  /// A trial as often as it came with the same answers.
  struct Cell {
    const AnsweredTrial* trial{nullptr};
    double count{1.0};
    std::vector<RatedOutcome> outcomes;  ///< where no trait changes them, and there is a rating
  };
  /// What one person answered.
  struct Person {
    std::vector<Cell> cells;
    std::vector<GivenRating> ratings;  ///< each once
    double known_logarithm{0.0};       ///< of all answers that no smooth trait changes
    Traits likely{};                   ///< about where they explain the person best
  };

  void list_movable();
  void list_spreads(bool as_group);
  void tell_thresholds_apart();
  [[nodiscard]] bool can_be() const;
  [[nodiscard]] double clearest(const AnsweredTrial& trial, const Traits& traits) const;
  [[nodiscard]] double look(const AnsweredTrial& trial, const Traits& traits,
                            std::vector<Outcome>& outcomes) const;
  [[nodiscard]] double unrated_chance(const AnsweredTrial& trial, double seen) const;
  [[nodiscard]] double answered_chance(const AnsweredTrial& trial, const Traits& traits,
                                       double seen) const;
  [[nodiscard]] double choice_chance(const AnsweredTrial& trial, const Traits& traits) const;
  [[nodiscard]] bool must_judge();
  void judge(Person& person, const Traits& own) const;
  [[nodiscard]] double answers_logarithm(Person& person, const Traits& own) const;
  [[nodiscard]] double over_smooth(Person& person, const Traits& own,
                                   Eigen::VectorXd& highest) const;
  [[nodiscard]] double integral(Person& person) const;

  const AnswerModel* model_;
  std::shared_ptr<RatingParameters> parameters_;
  std::vector<MovableParameter> movable_;
  std::vector<TraitSpread> spreads_;  ///< in which people differ
  std::vector<TraitSpread> smooth_;   ///< of these: answers go by them smoothly
  bool threshold_differs_{false};     ///< by which what is seen may go in steps
  std::vector<Person> people_;
  std::optional<std::vector<double>> judged_by_;  ///< what all but ratings go by; none: not yet
};

}  // namespace impetus::inline fitting
