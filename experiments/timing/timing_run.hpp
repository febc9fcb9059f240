// Measures what a timing report tells, part by part, by the path that a session's trials take.
//
//   sync test ─> blank flips ─> 1, 15, 250 bodies as trials ─> input sent to itself ─> coded patch
//         └ sounds, where asked for  └ gaze sample to flip, flip to marker (15)
//
// Knows the lab by interfaces, so that it runs without a window, too.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "experiments/record/photodiode_patch.hpp"
#include "experiments/record/ports.hpp"
#include "experiments/record/sent_input.hpp"
#include "experiments/scenes/shape_library.hpp"
#include "experiments/timing/timing_report.hpp"

namespace impetus::inline timing {

/// The trial that shows so many bodies.
PlannedTrial timing_trial(int bodies);

/// The scenes that a timing report shows: shipped ones, at their own step rate.
///
///   up to 100 bodies   L-blocks bounce in a cube, detailed about the gaze
///   more               creatures crowd a cube, by their own schedule and budget
class TimingScenes final : public Scenes {
 public:
  /// Every scene lasts so long. `shapes` must outlive this.
  TimingScenes(double duration_s, ShapeLibrary& shapes)
      : duration_s_(duration_s), shapes_(&shapes) {}

  /// The scene of a timing_trial().
  [[nodiscard]] StagedScene stage(const PlannedTrial& trial,
                                  const ScreenGeometry& screen) const override;
  /// There are none: throws std::logic_error.
  [[nodiscard]] StagedScene stage_demonstration(const std::string& id,
                                                const ScreenGeometry& screen) const override;

 private:
  double duration_s_;
  ShapeLibrary* shapes_;
};

/// What is measured, as interfaces: a window or a stand-in for one.
class TimingLab {
 public:
  virtual ~TimingLab() = default;
  virtual Display& display() = 0;
  virtual Input& input() = 0;
  virtual Gaze& gaze() = 0;
  /// How the clock of what tells the gaze stands to this machine's, in words; "": it is the same.
  [[nodiscard]] virtual std::string gaze_clock() const { return ""; }
  /// Who is told of events, with every one's code; none: nobody.
  virtual Markers* markers() { return nullptr; }
  [[nodiscard]] virtual std::string marker_address() const { return ""; }
  /// What plays; none: no sound was asked for.
  virtual Sounds* sounds() { return nullptr; }
  [[nodiscard]] virtual std::string sound_device() const { return ""; }
  /// Of flips, gaze samples, input and sounds.
  [[nodiscard]] virtual const Clock& clock() const = 0;
  virtual SyncTest sync_test() = 0;

  /// Shows pictures until `show` returns false, and sends input to the program meanwhile.
  virtual InputTrace try_input(const std::function<bool()>& show) = 0;

  /// From now on a photodiode patch is drawn.
  virtual void show_patch(ScreenCorner corner) = 0;
  /// Whether the window system can be asked for what it shows.
  [[nodiscard]] virtual bool can_read_patch() = 0;
  /// The code that the window system holds where the patch is; none: it is no code.
  virtual std::optional<std::int64_t> read_patch() = 0;
};

/// What is asked of a run.
struct TimingTask {
  double seconds{10.0};  ///< of each part
  ScreenCorner corner{ScreenCorner::kBottomLeft};
};

/// What is measured next, and how long all of it still takes.
using TellPart = std::function<void(const SessionProgress& progress)>;

/// `scenes` are TimingScenes of the task's length. Fills in all but the report's facts. None: it
/// was stopped by Esc or by closing the window.
std::optional<TimingReport> run_timing(TimingLab& lab, const Scenes& scenes, const TimingTask& task,
                                       const TellPart& tell);

}  // namespace impetus::inline timing
