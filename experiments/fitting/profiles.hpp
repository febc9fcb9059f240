// The profile of a likelihood: how far a parameter can go, all others following, until the answers
// are less probable by 1.92 in the logarithm. That is its 95 % interval (Venzon and Moolgavkar
// 1988).
//
//   fall   0 ─────── inner ─────── 1.92 ─────── outer        from the best place, one way
//                      └─ the others, followed from the nearest inner place; the end, held against
//                         what is found there from where the whole search began, over a ridge
//
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "experiments/fitting/minimum.hpp"

namespace impetus::inline fitting {

/// Half the 95 % point of χ² with one degree of freedom.
inline constexpr double kProfileFall = 1.9207;

/// A parameter of a profile, on its scale.
struct ProfiledParameter {
  double reach{1.0};        ///< as good as infinitely far from 0
  bool may_end_low{false};  ///< there it is a value like others: nobody lapses
  bool may_end_high{false};
  bool moves_with_cuts{false};  ///< it is one of several that stay in order: the others move along
};

/// The profiles of all parameters about a minimum.
class Profiles {
 public:
  /// `cost` is minus the logarithm of the likelihood, `begun` where its search began, `best` its
  /// minimum, and `inverse` the inverse Hessian there; one of `parameters` for each of its numbers.
  Profiles(SmoothFunction cost, Eigen::VectorXd begun, FoundMinimum best, Eigen::MatrixXd inverse,
           std::vector<ProfiledParameter> parameters);

  /// Where the profile has fallen by kProfileFall, in the direction `sign`; none: nowhere within
  /// reach, or only since another parameter has come to the end of its own, or a better place than
  /// the best was found on the way.
  std::optional<double> end(std::size_t parameter, double sign);

  /// The better place that end() came upon; none: there was none.
  [[nodiscard]] const std::optional<FoundMinimum>& better() const { return better_; }

 private:
  /// A place of the profile.
  struct Place {
    double x{0.0};
    Eigen::VectorXd others;
    double root{0.0};      ///< of twice the fall: nearly a line in x
    bool is_bound{false};  ///< one of the others came to the end of its reach
  };

  [[nodiscard]] bool has_come_to_an_end(const Eigen::VectorXd& all) const;
  [[nodiscard]] Eigen::VectorXd whole(std::size_t parameter, double x,
                                      const Eigen::VectorXd& others) const;
  [[nodiscard]] Eigen::VectorXd others_of(std::size_t parameter, const Eigen::VectorXd& all) const;
  [[nodiscard]] Eigen::MatrixXd others_inverse(std::size_t parameter) const;
  [[nodiscard]] Eigen::VectorXd moved_along(std::size_t parameter, const Place& from,
                                            double x) const;
  std::optional<Place> end_from(std::size_t parameter, double sign, Place inner);
  [[nodiscard]] bool falls_on_the_way(std::size_t parameter, const Place& from,
                                      const Place& to) const;
  Place followed(std::size_t parameter, const Place& from, double x);

  SmoothFunction cost_;
  Eigen::VectorXd begun_;
  FoundMinimum best_;
  Eigen::MatrixXd inverse_;
  std::vector<ProfiledParameter> parameters_;
  std::optional<FoundMinimum> better_;
};

}  // namespace impetus::inline fitting
