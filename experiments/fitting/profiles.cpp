// SPDX-License-Identifier: MIT
#include "experiments/fitting/profiles.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace impetus::inline fitting {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kOthersTolerance = 1e-3;  ///< of searches, in the logarithm
constexpr double kBetter = 0.01;  ///< a place that is better than the best by so much is one
constexpr double kCloseRoot = 0.02;
constexpr double kCloseX = 1e-3;
constexpr double kLongestFirst = 1.0;  ///< on the scale: a longer step may leap over a ridge
constexpr int kMostValleys = 4;
constexpr int kMostSteps = 25;  ///< of the others: they begin near their end, or lead nowhere
constexpr int kMostPlaces = 60;

const double kTarget = std::sqrt(2.0 * kProfileFall);

}  // namespace

Profiles::Profiles(SmoothFunction cost, VectorXd begun, FoundMinimum best, MatrixXd inverse,
                   std::vector<ProfiledParameter> parameters)
    : cost_(std::move(cost)),
      begun_(std::move(begun)),
      best_(std::move(best)),
      inverse_(std::move(inverse)),
      parameters_(std::move(parameters)) {}

std::optional<double> Profiles::end(std::size_t parameter, double sign) {
  const auto at = static_cast<Index>(parameter);
  better_.reset();
  const Place begun{begun_[at], others_of(parameter, begun_)};
  Place inner{best_.at[at], others_of(parameter, best_.at)};
  for (int valley = 0; valley < kMostValleys; ++valley) {
    const std::optional<Place> found = end_from(parameter, sign, inner);
    if (!found || falls_on_the_way(parameter, begun, *found)) {
      return found ? std::optional(found->x) : std::nullopt;
    }
    Place there = followed(parameter, begun, found->x);
    if (better_) {
      return {};
    }
    if (there.root > kTarget - kCloseRoot) {
      return found->x;
    }
    inner = std::move(there);  // what was followed had led into another valley
  }
  return {};
}

/// Whether no ridge lies on the straight way from one place's others to the other's, at its x: both
/// are in one valley. Looked at in eight places, of a fraction of a search's cost.
bool Profiles::falls_on_the_way(std::size_t parameter, const Place& from, const Place& to) const {
  constexpr int kPlaces = 8;
  const VectorXd way = to.others - from.others;
  double before = cost_(whole(parameter, to.x, from.others));
  for (int place = 1; place <= kPlaces; ++place) {
    const double share = static_cast<double>(place) / kPlaces;
    const double here = cost_(whole(parameter, to.x, from.others + share * way));
    if (!(here <= before)) {
      return false;
    }
    before = here;
  }
  return true;
}

/// The same, the others followed from `inner` on, wherever that leads.
std::optional<Profiles::Place> Profiles::end_from(std::size_t parameter, double sign, Place inner) {
  const auto at = static_cast<Index>(parameter);
  const double end = sign * parameters_[parameter].reach;
  std::optional<Place> outer;
  double inner_weight = 1.0;
  double outer_weight = 1.0;
  double step =
      std::clamp(kTarget * std::sqrt(std::max(inverse_(at, at), 0.0)), kCloseX, kLongestFirst);
  for (int count = 0; count < kMostPlaces; ++count) {
    double x = inner.x + sign * step;
    if (outer) {
      const double below = inner_weight * (kTarget - inner.root);
      const double above = outer_weight * (outer->root - kTarget);
      x = inner.x + (outer->x - inner.x) * below / (below + above);
    } else if (sign * (end - x) <= 0.0) {
      x = end;
    }
    Place there = followed(parameter, inner, x);
    if (better_ || (there.root > kTarget && there.is_bound)) {
      return {};
    }
    if (std::abs(there.root - kTarget) < kCloseRoot) {
      return there;
    }
    // A side that is kept twice counts half as much, or its other end would hardly move (Illinois;
    // Dowell and Jarratt 1971).
    if (there.root > kTarget) {
      inner_weight = outer ? 0.5 * inner_weight : 1.0;
      outer_weight = 1.0;
      outer = std::move(there);
    } else {
      if (!outer && x == end) {
        return {};
      }
      const double slope = (there.root - inner.root) / std::max(std::abs(x - inner.x), 1e-9);
      const double needed = slope > 1e-6 ? 1.02 * (kTarget - there.root) / slope : 2.0 * step;
      step = std::clamp(needed, 0.1 * step, 2.0 * step + 0.5);
      outer_weight = outer ? 0.5 * outer_weight : 1.0;
      inner_weight = 1.0;
      inner = std::move(there);
    }
    if (outer && std::abs(outer->x - inner.x) < kCloseX) {
      return outer;
    }
  }
  return {};
}

/// The place at `x`, the others followed from where they are at `from`: never worse than these.
Profiles::Place Profiles::followed(std::size_t parameter, const Place& from, double x) {
  const SmoothFunction cost_of_others = [&](const VectorXd& others) {
    return cost_(whole(parameter, x, others));
  };
  VectorXd guess = moved_along(parameter, from, x);
  if (!(cost_of_others(guess) <= cost_of_others(from.others))) {
    guess = from.others;
  }
  const FoundMinimum found =
      find_minimum(cost_of_others, guess, kOthersTolerance, others_inverse(parameter), kMostSteps);
  if (found.value < best_.value - kBetter) {
    better_ = FoundMinimum{whole(parameter, x, found.at), found.value};
  }
  const double fall = found.value - best_.value;
  const double root = std::isfinite(fall) ? std::sqrt(2.0 * std::max(fall, 0.0)) : 10.0 * kTarget;
  return {x, found.at, root, has_come_to_an_end(whole(parameter, x, found.at))};
}

/// Whether a parameter that was not at an end of its reach is at one where it stands for infinity.
bool Profiles::has_come_to_an_end(const VectorXd& all) const {
  constexpr double kNearly = 0.95;
  for (std::size_t i = 0; i < parameters_.size(); ++i) {
    const ProfiledParameter& one = parameters_[i];
    const double x = all[static_cast<Index>(i)];
    const double at_best = best_.at[static_cast<Index>(i)];
    const bool may_end = x < 0.0 ? one.may_end_low : one.may_end_high;
    const double end = kNearly * one.reach;
    if (!may_end && std::abs(x) >= end && std::abs(at_best) < end) {
      return true;
    }
  }
  return false;
}

/// Cuts go together, or their order would stop one; else as the curvature at the best place says.
VectorXd Profiles::moved_along(std::size_t parameter, const Place& from, double x) const {
  const auto at = static_cast<Index>(parameter);
  VectorXd others = from.others;
  if (!parameters_[parameter].moves_with_cuts) {
    return others + others_of(parameter, inverse_.col(at)) / std::max(inverse_(at, at), 1e-12) *
                        (x - from.x);
  }
  for (std::size_t i = 0; i < parameters_.size(); ++i) {
    if (i != parameter && parameters_[i].moves_with_cuts) {
      others[static_cast<Index>(i < parameter ? i : i - 1)] += x - from.x;
    }
  }
  return others;
}

VectorXd Profiles::whole(std::size_t parameter, double x, const VectorXd& others) const {
  const auto at = static_cast<Index>(parameter);
  VectorXd all(best_.at.size());
  all << others.head(at), x, others.tail(others.size() - at);
  return all;
}

VectorXd Profiles::others_of(std::size_t parameter, const VectorXd& all) const {
  const auto at = static_cast<Index>(parameter);
  VectorXd others(all.size() - 1);
  others << all.head(at), all.tail(all.size() - at - 1);
  return others;
}

/// The inverse Hessian of the others when one is fixed: what is left of it (Schur).
MatrixXd Profiles::others_inverse(std::size_t parameter) const {
  const auto at = static_cast<Index>(parameter);
  const MatrixXd given =
      inverse_ - inverse_.col(at) * inverse_.row(at) / std::max(inverse_(at, at), 1e-12);
  MatrixXd others(given.rows() - 1, given.cols() - 1);
  for (Index column = 0; column < given.cols(); ++column) {
    if (column != at) {
      others.col(column < at ? column : column - 1) = others_of(parameter, given.col(column));
    }
  }
  return others + 1e-6 * MatrixXd::Identity(others.rows(), others.cols());
}

}  // namespace impetus::inline fitting
