// One adaptive track: the levels of its trials, each decided by the answers before it.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "experiments/design/quest_plus.hpp"
#include "experiments/design/staircase.hpp"

namespace impetus::inline design {

class AdaptiveTrack {
 public:
  explicit AdaptiveTrack(std::variant<StaircaseTrack, QuestPlusTrack> method)
      : method_(std::move(method)) {}

  /// The level of the next trial, as an index into the factor's levels.
  [[nodiscard]] std::size_t level() const;

  /// A trial was shown at `level`. One without an answer that counts (timed out) is one of the
  /// track's trials, but leaves what the track knows as it was.
  void answer(std::size_t level, std::optional<bool> positive);

  /// What the track knows: its trials so far, then the method's own state, by name.
  [[nodiscard]] std::vector<FactorLevel> state() const;

 private:
  std::variant<StaircaseTrack, QuestPlusTrack> method_;
  std::int64_t trials_{0};
};

}  // namespace impetus::inline design
