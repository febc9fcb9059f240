// Replay: a recorded trial simulated again from its inputs, and the proof that it is the same.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "experiments/session/record.hpp"
#include "experiments/session/staged_scene.hpp"

namespace impetus {

/// Where a replay first left the recording.
struct Divergence {
  std::int64_t step{0};
  std::string body;   ///< "" when no digest of the recording differs, only hashes
  std::string field;  ///< "position", ...
  /// The step whose digests name body and field: `step`, but for one change in 65,536, which
  /// leaves a digest of 16 bits as it was; then the first step after it that tells.
  std::int64_t named_at{0};
};

/// A body that was taken out, since what is named of its state was not finite.
struct TakenOut {
  std::int64_t step{0};
  std::string body;
  std::string field;  ///< "position", ...
};

struct ReplayResult {
  std::int64_t steps{0};  ///< simulated, the start not counted
  std::optional<Divergence> divergence;
  std::vector<TakenOut> taken_out{};  ///< by then
};

/// Called after each step with its number, the world and its report; for step 0 the report is
/// empty.
using StepWatcher =
    std::function<void(std::int64_t step, const World& world, const StepReport& report)>;

/// Steps `scene` through `recorded`, giving each step the gaze, the region and the work that it was
/// given then, and stops once a state's hash differs and is known by body and field. With a watcher
/// it goes on to the end.
ReplayResult replay(StagedScene scene, const std::vector<StepRecord>& recorded,
                    const StepWatcher& watcher = {});

}  // namespace impetus
