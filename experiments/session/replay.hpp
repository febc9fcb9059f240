// Replay: a recorded trial simulated again from its inputs, and the proof that it is the same.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "experiments/session/record.hpp"
#include "experiments/session/staged_scene.hpp"

namespace impetus {

/// Where a replay first left the recording.
struct Divergence {
  std::int64_t step{0};
  std::string body;   ///< "" when the digests agree and only the hash differs
  std::string field;  ///< "position", ...
};

struct ReplayResult {
  std::int64_t steps{0};  ///< simulated, the start not counted
  std::optional<Divergence> divergence;
  std::vector<std::vector<BodyState>> states;  ///< [step][body], only when asked for
};

/// Steps `scene` through `recorded`, granting each step the work that was granted then, and stops
/// at the first state whose hash differs. `keep_states` keeps every state for the viewer and goes
/// on to the end.
ReplayResult replay(StagedScene scene, const std::vector<StepRecord>& recorded,
                    bool keep_states = false);

}  // namespace impetus
