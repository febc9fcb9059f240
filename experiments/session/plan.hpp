// The plan: every slot, condition and seed, decided and stored before the first trial is shown.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "experiments/session/design.hpp"

namespace impetus {

enum class TrialPhase { kPractice, kMain };

struct PlannedTrial {
  std::int64_t slot{0};  ///< place in the session, from 1, practice first
  TrialPhase phase{TrialPhase::kMain};
  std::int64_t repetition{1};  ///< of practice: its round
  Condition condition;
  std::uint64_t seed{0};

  friend bool operator==(const PlannedTrial&, const PlannedTrial&) = default;
};

using Plan = std::vector<PlannedTrial>;

/// Whose plan it is: the order depends on these three alone, on every machine.
struct PlanKey {
  std::string protocol;
  std::string participant;
  std::uint64_t seed{0};
};

/// Practice in its given order, then every cell × repetition in an order drawn uniformly from
/// those that satisfy the design's longest runs. Throws std::runtime_error when 100,000 draws
/// found none.
Plan make_plan(const Design& design, const PlanKey& key);

}  // namespace impetus
