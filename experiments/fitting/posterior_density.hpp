// How probable parameters are in the light of people's answers and of what was assumed before.
//
//   log P(parameters | answers) = log P(answers | parameters) + Σ log prior
//
// Priors are normal on the scale on which a fit moves a parameter (likelihood.hpp), about what the
// observer's file assumes: weak, so that answers that tell of a parameter overrule them.
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "experiments/fitting/fit.hpp"

namespace impetus::inline fitting {

/// The posterior of an observer's parameters, on their scales. Parameters on which no answer
/// depends are no part of it.
class PosteriorDensity {
 public:
  /// `assumed` and `people` as they were for `fit`; `people` must outlive this.
  PosteriorDensity(const ObserverKind& kind, const RatingParameters& assumed,
                   const std::vector<AnsweringPerson>& people, const ObserverFit& fit);

  [[nodiscard]] std::size_t size() const { return free_.size(); }
  [[nodiscard]] const std::string& name(std::size_t parameter) const;
  /// The parameter's value at a place on its scale.
  [[nodiscard]] double value(std::size_t parameter, double x) const;
  [[nodiscard]] double prior_centre(std::size_t parameter) const;
  [[nodiscard]] double prior_sd(std::size_t parameter) const;

  /// But for a constant; −∞ where the parameters cannot be.
  [[nodiscard]] double logarithm(const Eigen::VectorXd& x);

  /// Where it is highest, and its covariance there, were it normal.
  [[nodiscard]] const Eigen::VectorXd& mode() const { return mode_; }
  [[nodiscard]] const Eigen::MatrixXd& covariance() const { return covariance_; }

 private:
  [[nodiscard]] const MovableParameter& movable(std::size_t parameter) const {
    return likelihood_.movable()[free_[parameter]];
  }

  AnswerLikelihood likelihood_;
  std::vector<std::size_t> free_;  ///< of movable()
  Eigen::VectorXd centre_;
  Eigen::VectorXd mode_;
  Eigen::MatrixXd covariance_;
};

}  // namespace impetus::inline fitting
