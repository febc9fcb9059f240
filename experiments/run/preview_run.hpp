// A scene that runs for as long as somebody looks at it, while its schedule and budget change.
//
//   real time --speed--> steps at step_hz --> what the overlays show: pairs, contacts, work
//
// A step that could not be done in time is done late: the run falls behind real time rather than
// skipping one, and says by how much.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "experiments/record/ports.hpp"
#include "experiments/run/body_detail.hpp"
#include "experiments/run/preview_settings.hpp"
#include "experiments/run/scene_run.hpp"

namespace impetus::inline run {

/// One step in the strip chart, in node-pair tests.
struct WorkOfStep {
  std::int64_t spent{0};
  std::int64_t floor{0};    ///< done whatever the budget
  std::int64_t granted{0};  ///< what the budget allowed; as much as `spent` when it is unlimited
};

/// A contact that is kept in view for a while, since it lasts one step; of the newest of its pair.
struct ShownContact {
  BodyPair bodies;
  TouchPoint touch;
  int list{0};
  std::int64_t step{0};
};

/// Runs a scene in real time for somebody who changes its settings meanwhile.
class PreviewRun {
 public:
  /// Starts playing. `clock` times steps and must outlive this.
  PreviewRun(StagedScene scene, const Clock& clock);

  /// Moves on by `real_s` of real time, when playing.
  void advance(double real_s);
  void toggle() { playing_ = !playing_; }
  /// Stands still, exactly on the next step.
  void step();
  /// The scene from its onset again, under the settings as they are.
  void restart();
  /// Times real time: 1 or less.
  void set_speed(double factor) { speed_ = factor; }

  /// From the next step on. An impossible schedule leaves the last good one running, and problem()
  /// says why; all else is taken all the same.
  void change(const PreviewSettings& settings);
  [[nodiscard]] const PreviewSettings& settings() const { return settings_; }
  [[nodiscard]] const std::string& problem() const { return problem_; }

  /// Whether node_contacts() are found: they cost time.
  void watch_node_contacts(bool watch);

  /// Where the viewer looks from the next step on.
  void look_at(const ScreenPoint& point) { gaze_ = point; }
  [[nodiscard]] const Fixation& gaze() const { return gaze_; }
  /// The region of the last step; one about the gaze is where the next step will have it.
  [[nodiscard]] std::optional<GazeRegion> region() const;

  [[nodiscard]] const StagedScene& scene() const { return run_.scene(); }
  [[nodiscard]] bool playing() const { return playing_; }
  [[nodiscard]] double speed() const { return speed_; }
  [[nodiscard]] std::int64_t step_number() const { return run_.number(); }
  [[nodiscard]] std::int64_t collision_count() const { return collision_count_; }
  /// Pairs that fell to a coarser level while they touched.
  [[nodiscard]] std::int64_t pop_count() const { return pop_count_; }
  /// Pairs that were stopped where they would have passed through each other.
  [[nodiscard]] std::int64_t stopped_count() const { return stopped_count_; }
  /// Steps in which something kept them from being what they should, by kDegradationNames.
  [[nodiscard]] const std::array<std::int64_t, kDegradationNames.size()>& degraded_counts() const {
    return degraded_counts_;
  }
  /// Kinetic energy now as a share of that at the onset; 0 when nothing moved then.
  [[nodiscard]] double energy_share() const;
  /// Scene time gone by as a share of what was asked for, over the last second or so.
  [[nodiscard]] double pace() const { return pace_; }
  /// What a step takes by the clock, averaged over the last few (milliseconds).
  [[nodiscard]] double step_ms() const { return step_ms_; }

  [[nodiscard]] Viewer viewer() const;
  /// The scene as it is now, poses between steps included.
  [[nodiscard]] Picture picture() const;
  /// The last step's, by list.
  [[nodiscard]] const std::vector<ScheduledPair>& pairs() const { return run_.world().pairs(); }
  /// What is still in view, oldest first.
  [[nodiscard]] const std::deque<ShownContact>& contacts() const { return contacts_; }
  /// The same of overlapping nodes, before the reduction; at most 500 of a pair.
  [[nodiscard]] const std::deque<ShownContact>& node_contacts() const { return node_contacts_; }
  /// 1 for a contact of the last step, falling to 0 as it leaves the view.
  [[nodiscard]] double freshness(const ShownContact& contact) const;
  /// Of each body, the level of its last collision while that is in view; 0 while it is in a pair
  /// at all; otherwise -1. And the most urgent list that it has a pair in.
  [[nodiscard]] std::vector<BodyDetail> details() const;
  /// The last few seconds, oldest first.
  [[nodiscard]] const std::deque<WorkOfStep>& work() const { return work_; }
  /// Steps that work() reaches back at most.
  [[nodiscard]] std::size_t work_span() const;

 private:
  void step_once();
  /// The gaze, or the centre of the screen as long as the mouse was nowhere.
  [[nodiscard]] ScreenPoint looked_at() const;
  std::optional<GazeRegion> region_of_step();
  void apply_settings();
  void keep(const StepReport& report);
  void keep_contacts(const StepReport& report, const CollisionReport& collision);
  void forget_old();

  const Clock* clock_;
  StagedScene start_;
  SceneRun run_;
  PreviewSettings settings_;
  std::string problem_;
  Fixation gaze_;

  bool playing_{true};
  double speed_{1.0};
  double position_{0.0};  ///< in steps, within the last one
  double pace_{1.0};
  double step_ms_{0.0};
  double start_energy_J_{0.0};
  std::int64_t collision_count_{0};
  std::int64_t pop_count_{0};
  std::int64_t stopped_count_{0};
  std::array<std::int64_t, kDegradationNames.size()> degraded_counts_{};
  bool watches_node_contacts_{false};

  LatestDetail latest_;
  std::deque<ShownContact> contacts_;
  std::deque<ShownContact> node_contacts_;
  std::deque<WorkOfStep> work_;
};

}  // namespace impetus::inline run
