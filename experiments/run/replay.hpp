// Replay: a recorded trial simulated again from its inputs, and the proof that it is the same.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "experiments/record/record.hpp"
#include "experiments/run/scene_run.hpp"

namespace impetus::inline run {

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

/// What a replay found so far.
struct ReplayResult {
  std::int64_t steps{0};  ///< simulated, the start not counted
  std::optional<Divergence> divergence;
  std::vector<TakenOut> taken_out{};  ///< by then
  double ends_s{0.0};                 ///< when the scene ends, as far as was known by then
};

/// What is known of a divergence after this step: `known` by now (none: there was none), begun
/// where the state is not the recorded one, and named as soon as a digest tells.
std::optional<Divergence> divergence_of(const StepRecord& recorded, const StateHash& actual,
                                        const World& world,
                                        const std::optional<Divergence>& known = {});

/// A replay that goes on step by step, for as long as its caller likes.
class RunningReplay {
 public:
  /// `recorded` must outlive this. Nothing is done yet: the first next() is of the start.
  RunningReplay(StagedScene scene, const std::vector<StepRecord>& recorded);

  [[nodiscard]] bool done() const { return next_ == recorded_->size(); }
  /// The number of the step that next() does. Precondition, for both: not done.
  [[nodiscard]] std::int64_t next_step() const { return (*recorded_)[next_].step; }
  /// What it returns is empty for step 0, and stays until the next step.
  const StepReport& next();

  [[nodiscard]] const StagedScene& scene() const { return run_.scene(); }
  [[nodiscard]] const SceneRun& scene_run() const { return run_; }
  /// By now. The divergence is the first.
  [[nodiscard]] const ReplayResult& result() const { return result_; }

 private:
  SceneRun run_;
  const std::vector<StepRecord>* recorded_;
  StepReport start_;
  std::size_t next_{0};
  ReplayResult result_;
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

}  // namespace impetus::inline run
