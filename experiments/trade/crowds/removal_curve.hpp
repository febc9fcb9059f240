// How much of a step's visible error work removes, in one order or another, knowing each outcome.
//
//   removed │        ·······  hindsight: the steepest pieces of all pairs' hulls first
//           │     ·  ┌────   an order: a pair's level counts when it is complete
//           │  · ┌───┘
//           └────────────── work on tests beyond the roots'
//
// Choosing for each pair the level to stop at, within so much work, is a knapsack of which each
// pair takes one of several sizes. Cutting its items into arbitrarily small pieces can only help:
// then the best is known, namely to take the pieces of each pair's upper concave hull, steepest
// first (Sinha and Zoltners 1979). No order that stops anywhere can remove more: it is a bound, and
// where it has just finished a piece it is what the best order reaches.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "experiments/trade/crowds/pair_levels.hpp"

namespace impetus::inline trade {

/// Which of the two errors is meant.
using ErrorOf = double VisibleError::*;

/// The error removed as a function of the work spent.
class RemovalCurve {
 public:
  /// The bound that no order can exceed.
  static RemovalCurve in_hindsight(const std::vector<PairLevels>& pairs, ErrorOf error);

  /// One pair after the other, each to the end; `order` are places in `pairs`.
  static RemovalCurve depth_first(const std::vector<PairLevels>& pairs, ErrorOf error,
                                  const std::vector<std::size_t>& order);

  /// Level after level, the pairs of each in `order`.
  static RemovalCurve breadth_first(const std::vector<PairLevels>& pairs, ErrorOf error,
                                    const std::vector<std::size_t>& order);

  /// What so much work removes (minutes of arc at the fovea); never less than nothing is spent for.
  [[nodiscard]] double removed(std::int64_t work) const;

  /// All of it: what the finest levels remove.
  [[nodiscard]] std::int64_t work() const { return points_.back().work; }
  [[nodiscard]] double removed() const { return points_.back().removed; }

 private:
  /// So much work has removed so much error; or, of a piece, removes more.
  struct Point {
    std::int64_t work{0};
    double removed{0.0};
  };

  explicit RemovalCurve(bool in_pieces) : in_pieces_(in_pieces) {}
  void add(const Point& piece);

  bool in_pieces_;  ///< part of a level's work removes part of what the level removes
  std::vector<Point> points_{Point{}};
};

/// Left when every pair stands at its root, and when every pair stands at its finest level.
double left_at_roots(const std::vector<PairLevels>& pairs, ErrorOf error);
double left_at_finest(const std::vector<PairLevels>& pairs, ErrorOf error);

}  // namespace impetus::inline trade
