// How much work a step may do, counted in units that do not depend on the machine (work_costs.hpp).
//
//   |<--------- total that is asked for --------->|
//   |  spent and about to be spent  |  reserved   |     reserved for modelling and response, which
//                                                       follow when detection ends
//
// The engine reads no clock. A meter grants work when asked; the total that it granted, logged,
// is all that a replay needs. For what is asked depends on the state and on the answers so far
// alone, and an answer matters only by whether it reaches what was asked. Let G be the largest
// answer of a step. A request that was granted asked for at most its answer, so at most G. A
// request that was refused asked for more than its answer, which by the contract below was the
// largest there ever was in the step: more than G. So "at most G" decides every request as the live
// meter did, in turn, whatever made it refuse; and that is what FixedWork(G) answers.
// (Dingliana 2002, sec. 3.3.1; eq. 3.9, corrected)
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>

namespace impetus::inline scheduling {

/// Grants a step its work, in as many requests as the step likes.
class WorkMeter {
 public:
  virtual ~WorkMeter() = default;

  /// Asks that the step's work may come to `total` units, of which `reserved` are for the phases
  /// that follow detection; returns the total granted so far. The work may be done only if the
  /// answer is at least `total`. Totals may fall, when a reserve is released. Once a request is
  /// refused the answer never rises again within the step, and it is no smaller than any before:
  /// that makes the total sufficient for a replay.
  virtual std::int64_t request(std::int64_t total, std::int64_t reserved) = 0;
};

/// Grants up to a fixed number of units in each step. Also replays a recording: the total granted
/// then, granted now.
class FixedWork final : public WorkMeter {
 public:
  explicit FixedWork(std::int64_t units_per_step) : units_per_step_(units_per_step) {}

  std::int64_t request(std::int64_t total, std::int64_t /*reserved*/) override {
    return std::min(total, units_per_step_);
  }

 private:
  std::int64_t units_per_step_;
};

inline constexpr std::int64_t kUnlimitedTests = INT64_MAX;

}  // namespace impetus::inline scheduling
