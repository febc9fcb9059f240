// One up-down staircase over a list of levels, from hard (first) to easy (last).
//
//   `down` positives in a row -> harder        `up` negatives in a row -> easier
//
// A change of direction is a reversal; the step that makes it is already the next of the list. At
// either end of the levels it stays there. With small equal steps it settles where a step down
// and a step up are equally likely (Levitt 1971).
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "experiments/design/design.hpp"

namespace impetus::inline design {

/// Where one staircase stands.
class StaircaseTrack {
 public:
  /// Begins at level `start`, less than `level_count`.
  StaircaseTrack(const Staircase& rule, std::size_t level_count, std::size_t start)
      : rule_(rule),
        last_level_(static_cast<std::int64_t>(level_count) - 1),
        level_(static_cast<std::int64_t>(start)) {}

  /// The level of the next trial.
  [[nodiscard]] std::size_t level() const { return static_cast<std::size_t>(level_); }

  /// The answer to a trial at level().
  void answer(bool positive);

  /// What decides the next levels, by name.
  [[nodiscard]] std::vector<FactorLevel> state() const;

 private:
  /// Of the last move; none before the first.
  enum class Direction { kNone, kHarder, kEasier };

  void move(Direction direction);
  [[nodiscard]] std::int64_t step() const;

  Staircase rule_;
  std::int64_t last_level_;
  std::int64_t level_;
  std::int64_t positives_{0};  ///< in a row, since the last move
  std::int64_t negatives_{0};
  std::int64_t reversals_{0};
  Direction direction_{Direction::kNone};
};

/// The share of positive answers at which a staircase with small equal steps settles, from 0 to 1:
/// there `down` positives in a row come before `up` negatives in a row as often as not.
double settling_share(const Staircase& rule);

}  // namespace impetus::inline design
