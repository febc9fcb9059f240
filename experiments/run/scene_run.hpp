// A scene in time: the one place where a scene's world takes a step.
//
//   onset ──step──> ──step──> ...   each is told where the viewer looks and which region is of high
//                                   priority, and is given a meter of the work that it may do
//
// Whoever runs a scene watches one of these: the live trial and the preview give each step what the
// scene's own rules say, a replay and a what-if what was recorded, pilots and `impetus trade` what
// they try. The number of a step times the length of one is the time at its end, so step 1 is the
// first and the start has the number 0. While a scene is still its steps are counted, but its world
// takes none.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "engine/scheduling/deadline_work.hpp"
#include "engine/scheduling/workers.hpp"
#include "experiments/gaze/region_source.hpp"
#include "experiments/record/staged_scene.hpp"

namespace impetus::inline run {

/// Owns a scene's world, rule for regions and budget, and steps it.
class SceneRun {
 public:
  /// Stands at the scene's start. Random regions follow from `seed`, the trial's. `clock` times a
  /// budget in milliseconds and must outlive this; who gives each step a meter needs none.
  explicit SceneRun(StagedScene scene, std::uint64_t seed = 1, const WorkClock* clock = nullptr);

  /// Who helps with the steps of all scenes that are run from now on, or nobody, as at first. It
  /// changes how long they take, and nothing else. Steps within a budget in milliseconds are made
  /// alone. To be called before other threads run scenes.
  static void share_work_with(std::shared_ptr<Workers> workers);

  /// The region that the scene's rule has for the next step, for a viewer who looks at `fixation`.
  /// Whoever asks for it asks exactly once before each step.
  std::optional<GazeRegion> next_region(const Fixation& fixation);

  /// Takes the next step within the scene's own budget. The report stays until the next step.
  /// Throws std::logic_error when that is one in milliseconds and there is no clock.
  const StepReport& step(const Fixation& fixation = {},
                         const std::optional<GazeRegion>& region = {});
  /// The same with as much work as `meter` grants.
  const StepReport& step(const Fixation& fixation, const std::optional<GazeRegion>& region,
                         WorkMeter& meter);
  /// The same with all the work that there is, for who looks nowhere: what would be without limits.
  const StepReport& step_whole();

  /// Another budget, or another rule for regions, from the next step on. Random places go on as
  /// they were drawn.
  void set_budget(const WorkBudget& budget);
  void set_region_rule(const RegionRule& rule) { regions_.set_rule(rule); }

  /// The world as it is now, whose settings may change between steps.
  [[nodiscard]] World& world() { return scene_.world; }
  [[nodiscard]] const World& world() const { return scene_.world; }
  [[nodiscard]] const StagedScene& scene() const { return scene_; }

  /// When the stimulus ends, as far as is known now: when its time is over, or sooner by its goal.
  [[nodiscard]] double ends_s() const { return ends_s_; }

  /// How many steps were taken.
  [[nodiscard]] std::int64_t number() const { return number_; }
  /// The viewer at the end of step `number`.
  [[nodiscard]] Viewer viewer_at(std::int64_t number) const;
  /// What the last step was told; empty at the start.
  [[nodiscard]] const StepInput& input() const { return input_; }
  /// The states that the last step began with; at the start those of the start.
  [[nodiscard]] const std::vector<BodyState>& before() const { return before_; }
  /// The poses of all bodies within the last step: 0 is its begin, 1 its end.
  [[nodiscard]] std::vector<Pose> poses(double fraction) const;

 private:
  void impose_motions();
  [[nodiscard]] bool is_still() const;
  void watch_goal(const StepReport& report);

  StagedScene scene_;
  RegionSource regions_;
  const WorkClock* clock_;
  FixedWork fixed_{kUnlimitedTests};
  std::optional<DeadlineWork> deadline_;  ///< of a budget in milliseconds, where there is a clock
  bool needs_clock_{false};
  std::int64_t number_{0};
  StepReport stillness_;    ///< what a step reports in which the world takes none
  bool is_through_{false};  ///< the body of the scene's goal, where it has one
  double ends_s_;
  StepInput input_;
  std::vector<BodyState> before_;
};

/// Where the bodies of a collision touch: its contacts in the report, or its only one.
std::vector<TouchPoint> touch_points(const StepReport& report, const CollisionReport& collision);

}  // namespace impetus::inline run
