// What a session needs from the outside, as interfaces: a real window and a headless simulation
// implement the same ones, so that a simulated participant runs the very code a person runs.
//
//   Clock      when is it                     (monotonic, nanoseconds)
//   Display    show a picture at a flip       (what was measured comes back)
//   Input      ask a page, notice Esc, clicks (what was answered comes back)
//   Gaze       where the participant looks    (record/gaze.hpp)
//   Scenes     condition -> world             (what is on show)
//   Recorder   keep what happened             (an error is thrown, never swallowed)
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <ctime>
#include <optional>
#include <string>
#include <vector>

#include "engine/scheduling/deadline_work.hpp"
#include "engine/scheduling/viewer.hpp"
#include "engine/volumes/enclosure.hpp"
#include "experiments/design/design.hpp"
#include "experiments/design/plan.hpp"
#include "experiments/record/frame_grid.hpp"
#include "experiments/record/gaze.hpp"
#include "experiments/record/page.hpp"
#include "experiments/record/photodiode_patch.hpp"
#include "experiments/record/record.hpp"
#include "experiments/record/staged_scene.hpp"

namespace impetus::inline record {

/// When it is.
using Clock = WorkClock;

/// One body as it is drawn.
struct PosedBody {
  Pose pose;
  DrawnBody look;
};

/// One frame of a trial: all that drawing it needs.
struct Picture {
  bool fixation_cross{false};
  std::vector<PosedBody> bodies;
  std::optional<Enclosure> enclosure{};  ///< drawn as seen from inside: walls that face the eye
  bool pointer{false};                   ///< the mouse pointer is visible: it stands in for gaze
  Viewer viewer;
  std::shared_ptr<const Appearance> appearance{};  ///< none: painted plainly
  SessionProgress progress;
  Fixation target{};  ///< of a calibration: where a point to look at is drawn
  /// What a photodiode patch shows with it, where the display has one.
  std::int64_t patch_code{kDarkPatch};
};

/// The picture of the scene at `time_s` with its bodies in these poses; without poses, nothing but
/// the ground.
Picture picture_of(const StagedScene& scene, const std::vector<Pose>& poses, double time_s,
                   const SessionProgress& progress);

/// The screen: what shows pictures, each at a flip.
class Display {
 public:
  virtual ~Display() = default;

  /// Frames per second of the grid on which everything is scheduled (nominal rate).
  [[nodiscard]] virtual double refresh_hz() const = 0;
  [[nodiscard]] virtual const ScreenGeometry& geometry() const = 0;

  /// Starts a grid of slots one refresh apart at the next flip. Call it when timing may restart
  /// (after a page, an interval); within a trial's timed phases the grid goes on.
  virtual void restart_grid() = 0;

  /// Draws the picture for the grid's next slot, waits for it and flips. Frames are never skipped:
  /// after a miss the grid moves on by whole slots, and the flip says how many.
  virtual Flip show(const Picture& picture) = 0;

  /// Whether a photodiode patch is drawn on all that is shown.
  [[nodiscard]] virtual bool has_patch() const { return false; }
};

/// What a participant may do at any moment instead of answering.
enum class Interruption { kNone, kPauseRequested, kDisplayClosed };

/// What came back from a page.
struct Answer {
  Interruption interruption{Interruption::kNone};
  std::size_t choice{0};                   ///< index into the page's choices
  std::vector<std::string> fields;         ///< one per field of the page; "" when left empty
  std::string device;                      ///< "key", "mouse" or "simulated"
  std::int64_t shown_ns{0};                ///< flip that first showed the page
  std::int64_t arrived_ns{0};              ///< own stamp when the event was taken from the queue
  std::int64_t arrival_uncertainty_ns{0};  ///< the event may have arrived this much earlier
  std::int64_t late_frames{0};             ///< late flips while the page was up
  bool timed_out{false};                   ///< nothing came in the page's time; device is "none"
};

/// What the participant answers, and does meanwhile.
class Input {
 public:
  virtual ~Input() = default;

  /// Shows a page until it is answered, its time is up, the pause key is pressed (where the page
  /// allows it) or the display closes.
  virtual Answer ask(const Page& page) = 0;

  /// Whether a pause was asked for, or the display closed, since the last call. Called once per
  /// frame of a trial.
  virtual Interruption interruption() = 0;

  /// Clicks since the last call, in order. Called once per frame of a stimulus that asks for them
  /// and once more after witnessed(); what was clicked before the first stimulus is forgotten.
  virtual std::vector<ClickRecord> take_clicks() { return {}; }

  /// Tells what a trial showed, before its questions are asked; of two intervals, one after the
  /// other (the frames say which). A simulated participant judges by it; a person has seen it.
  virtual void witnessed(const AttemptRecord& shown, const StagedScene& scene) {
    static_cast<void>(shown);
    static_cast<void>(scene);
  }
};

/// What is on show under a condition.
class Scenes {
 public:
  virtual ~Scenes() = default;
  /// The scene of a planned trial, ready to step. Where bodies start at random, they start alike
  /// for every participant: the start follows from phase, condition and repetition alone.
  [[nodiscard]] virtual StagedScene stage(const PlannedTrial& trial,
                                          const ScreenGeometry& screen) const = 0;

  /// The scene of one of the script's demonstrations, by its id.
  [[nodiscard]] virtual StagedScene stage_demonstration(const std::string& id,
                                                        const ScreenGeometry& screen) const = 0;
};

/// Keeps what happened.
class Recorder {
 public:
  virtual ~Recorder() = default;

  /// Hands over one attempt at a trial; returns at once.
  virtual void save(AttemptRecord attempt) = 0;
  /// Hands over an answer outside trials (consent, age, strategy); returns at once.
  virtual void save(QuestionRecord answer) = 0;
  /// Hands over a remark about the session ("pause", "quit", ...); returns at once.
  virtual void save(NoteRecord note) = 0;
  /// Hands over an adaptive trial's level, before the trial is shown; returns at once.
  virtual void save(ChosenLevel chosen) = 0;
  /// Hands over one run through the points of a calibration; returns at once.
  virtual void save(CalibrationRecord calibration) = 0;
  /// Marks that this participant has done everything the protocol asks; returns at once.
  virtual void mark_finished() = 0;

  /// Waits until everything handed over is committed to disk. Throws when it could not be.
  virtual void await_saved() = 0;
};

/// One of the machine's clocks.
template <clockid_t kClock>
class MachineClock final : public Clock {
 public:
  [[nodiscard]] std::int64_t now_ns() const override {
    std::timespec now{};
    clock_gettime(kClock, &now);
    return std::int64_t{now.tv_sec} * 1'000'000'000 + now.tv_nsec;
  }
};

/// That which a change of date never moves.
using SteadyClock = MachineClock<CLOCK_MONOTONIC>;

/// The time that this thread has computed, so that what else the machine does is not in it. Looking
/// at it takes some tenths of a microsecond.
using ThreadClock = MachineClock<CLOCK_THREAD_CPUTIME_ID>;

}  // namespace impetus::inline record
