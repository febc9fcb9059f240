// SPDX-License-Identifier: MIT
#include "experiments/session/trial.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <memory>
#include <string>
#include <utility>

#include "experiments/gaze/gaze_follower.hpp"
#include "experiments/gaze/gaze_latency.hpp"
#include "experiments/gaze/gaze_loss.hpp"
#include "experiments/gaze/region_source.hpp"
#include "experiments/questions/response_kinds.hpp"
#include "experiments/questions/two_interval.hpp"
#include "experiments/record/frame_grid.hpp"
#include "experiments/run/live_run.hpp"

namespace impetus::inline session {
namespace {

/// One stimulus of a trial: the fixation cross, then the scene, with all that is recorded of it.
///
///   cross | frame 0, frame 1, ...    each frame shows the state for its scheduled time
///
/// A stimulus keeps a record of its own, because of two intervals an observer judges one by one; it
/// is appended to the trial's at the end.
class Stimulus {
 public:
  /// Everything but `shown` must outlive this. `interval` is 1, or 2 for the second of two. Throws
  /// what staging the scene throws.
  Stimulus(const PlannedTrial& shown, std::int64_t interval, const Script& script,
           const SessionProgress& progress, const Ports& ports, GazeFollower& follower);

  /// Shows cross and scene; returns what interrupted it.
  Interruption show();

  /// The pictures' ground alone, with the progress.
  [[nodiscard]] Picture blank() const { return with_pointer({}, 0.0); }

  /// Keeps the clicks since the last call, where clicks are asked for.
  void take_clicks();

  /// Tells the participant what was shown, and takes the clicks that this is answered with.
  void be_witnessed();

  /// Appends steps, collisions, frames, clicks and gaze; frames are numbered on.
  void append_to(AttemptRecord& record);

  [[nodiscard]] const StagedScene& scene() const { return live_.scene(); }

  /// Samples of the gaze younger than this are not used.
  [[nodiscard]] double imposed_gaze_latency_s() const;

  /// Of the scene's time so far, the share without a valid sample; none: gaze was not followed, or
  /// nothing was shown.
  [[nodiscard]] std::optional<double> gaze_lost_share() const { return record_.gaze_lost_share; }

  /// Of the enclosure's image, the share that was inside the region, on average.
  [[nodiscard]] std::optional<double> region_covered_share() const {
    return record_.region_covered_share;
  }

 private:
  bool show_fixation();
  bool show_scene();
  bool show_timed(const Picture& frame, FramePhase phase, double time_s);
  [[nodiscard]] Picture with_pointer(const std::vector<Pose>& poses, double time_s) const;
  void take_simulation(std::int64_t last_frame_shown);
  [[nodiscard]] std::int64_t first_frame(std::int64_t step, std::int64_t last_shown) const;

  std::int64_t interval_;
  const Script& script_;
  const SessionProgress& progress_;
  const Ports& ports_;
  GazeFollower& follower_;
  LiveRun live_;
  std::int64_t fixation_frames_{0};
  AttemptRecord record_;
  Interruption interruption_{Interruption::kNone};
};

template <typename T>
void append(std::vector<T>& to, std::vector<T>& from) {
  to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
  from.clear();
}

/// The scene, with the recorded gaze that a yoked trial's region follows.
StagedScene staged(const PlannedTrial& trial, const Ports& ports) {
  StagedScene scene = ports.scenes.stage(trial, ports.display.geometry());
  if (trial.yoked_trial_id) {
    const GazePath& path = ports.gaze_paths->at(*trial.yoked_trial_id);
    scene.recorded_gaze = std::make_shared<const GazePath>(
        path.seen_from(ports.display.geometry().viewing_distance_m));
  }
  return scene;
}

Stimulus::Stimulus(const PlannedTrial& shown, std::int64_t interval, const Script& script,
                   const SessionProgress& progress, const Ports& ports, GazeFollower& follower)
    : interval_(interval),
      script_(script),
      progress_(progress),
      ports_(ports),
      follower_(follower),
      live_(staged(shown, ports), shown.seed, ports.work_clock) {
  record_.slot = shown.slot;
  for (const BodyModel& body : scene().world.models()) {
    record_.body_names.push_back(body.name);
  }
  record_.wall_naming = wall_naming(scene().world.settings().enclosure);
  record_.intended_hold_s = scene().intended_hold_s;
  record_.realised_hold_s = scene().realised_hold_s;
  if (script.gaze && ports.gaze != nullptr) {
    record_.gaze_source = ports.gaze->source();
  }
}

double Stimulus::imposed_gaze_latency_s() const {
  return script_.gaze ? script_.gaze->extra_latency_ms / 1e3 + scene().gaze_latency_s : 0.0;
}

Interruption Stimulus::show() {
  if (show_fixation()) {
    show_scene();
  }
  return interruption_;
}

bool Stimulus::show_fixation() {
  Picture cross = blank();
  cross.fixation_cross = true;
  const std::int64_t frames =
      whole_frames(script_.timing.fixation_ms / 1e3, ports_.display.refresh_hz());
  for (std::int64_t frame = 0; frame < frames; ++frame) {
    if (!show_timed(cross, FramePhase::kFixation, 0.0)) {
      return false;
    }
  }
  return true;
}

bool Stimulus::show_scene() {
  const std::int64_t last_frame = whole_frames(scene().duration_s, ports_.display.refresh_hz());
  fixation_frames_ = static_cast<std::int64_t>(record_.frames.size());
  follower_.begin(static_cast<std::int64_t>(imposed_gaze_latency_s() * 1e9));
  if (takes_clicks(script_)) {
    static_cast<void>(ports_.input.take_clicks());
  }
  for (std::int64_t frame = 0; frame <= last_frame; ++frame) {
    const double time_s = static_cast<double>(frame) / ports_.display.refresh_hz();
    live_.look_at(follower_.look());
    Picture picture = with_pointer(live_.poses_at(time_s), time_s);
    picture.patch_code = patch_code(frame);
    if (!show_timed(picture, FramePhase::kStimulus, time_s)) {
      take_simulation(frame);
      return false;
    }
    take_clicks();
    if (frame == 0) {
      record_.onset_ns = record_.frames.back().flip.flipped_ns;
      record_.clicks.clear();  // made before there was anything to see
    }
  }
  take_simulation(last_frame);
  return true;
}

/// Shows and records one frame of a timed phase; false when that was interrupted.
bool Stimulus::show_timed(const Picture& frame, FramePhase phase, double time_s) {
  const Flip flip = ports_.display.show(frame);
  interruption_ = ports_.input.interruption();
  if (interruption_ != Interruption::kDisplayClosed) {  // else there was no flip
    const auto number = static_cast<std::int64_t>(record_.frames.size());
    record_.frames.push_back({number, phase, time_s, flip, interval_});
    if (ports_.display.has_patch()) {
      record_.frames.back().patch = frame.patch_code;
    }
    if (ports_.gaze != nullptr) {
      ports_.gaze->shown(frame, flip);
    }
  }
  return interruption_ == Interruption::kNone;
}

Picture Stimulus::with_pointer(const std::vector<Pose>& poses, double time_s) const {
  Picture picture = picture_of(scene(), poses, time_s, progress_);
  picture.pointer = script_.gaze && ports_.gaze != nullptr && ports_.gaze->is_pointer();
  return picture;
}

void Stimulus::take_clicks() {
  if (takes_clicks(script_)) {
    for (ClickRecord& click : ports_.input.take_clicks()) {
      click.interval = interval_;
      record_.clicks.push_back(std::move(click));
    }
  }
}

void Stimulus::be_witnessed() {
  ports_.input.witnessed(record_, scene());
  take_clicks();
}

void Stimulus::take_simulation(std::int64_t last_frame_shown) {
  record_.steps = live_.take_steps();
  for (StepRecord& step : record_.steps) {
    const std::int64_t first = first_frame(step.step, last_frame_shown);
    step.shown_frame = first < 0 ? -1 : fixation_frames_ + first;
    step.interval = interval_;
  }
  record_.collisions = live_.take_collisions();
  for (CollisionRecord& collision : record_.collisions) {
    collision.first_frame_shown = first_frame(collision.step, last_frame_shown);
    collision.interval = interval_;
  }
  record_.gaze = follower_.take_samples();
  for (GazeSample& sample : record_.gaze) {
    sample.interval = interval_;
  }
  if (!record_.gaze_source.empty() && record_.onset_ns != 0) {
    record_.gaze_lost_share = impetus::gaze_lost_share(record_.gaze, record_.onset_ns,
                                                       record_.frames.back().flip.flipped_ns);
  }
  record_.region_covered_share = mean_covered_share(scene(), record_.steps);
}

/// Of the stimulus, the first frame that shows the step whole; −1 when none did.
std::int64_t Stimulus::first_frame(std::int64_t step, std::int64_t last_shown) const {
  const double frames_per_step = ports_.display.refresh_hz() / scene().step_hz;
  const double frame = std::ceil(static_cast<double>(step) * frames_per_step - 1e-9);
  return static_cast<std::int64_t>(frame) <= last_shown ? static_cast<std::int64_t>(frame) : -1;
}

void Stimulus::append_to(AttemptRecord& record) {
  const auto shown_before = static_cast<std::int64_t>(record.frames.size());
  for (FrameRecord& frame : record_.frames) {
    frame.frame += shown_before;
  }
  for (StepRecord& step : record_.steps) {
    step.shown_frame += step.shown_frame >= 0 ? shown_before : 0;
  }
  if (record.onset_ns == 0) {
    record.onset_ns = record_.onset_ns;
  }
  if (record.body_names.size() < record_.body_names.size()) {
    record.body_names = record_.body_names;
  }
  append(record.steps, record_.steps);
  append(record.collisions, record_.collisions);
  append(record.frames, record_.frames);
  append(record.clicks, record_.clicks);
  append(record.gaze, record_.gaze);
}

const char* name_of(Interruption interruption) {
  return interruption == Interruption::kPauseRequested  ? "pause"
         : interruption == Interruption::kDisplayClosed ? "display closed"
                                                        : kGazeLostNote;
}

/// Runs the phases of one attempt in order; a phase returns false when it was interrupted.
class Attempt {
 public:
  Attempt(const PlannedTrial& trial, std::int64_t number, const Script& script,
          const SessionProgress& progress, const Ports& ports, bool may_be_repeated)
      : script_(script),
        progress_(progress),
        asked_{trial, progress_, test_interval(script, trial)},
        ports_(ports),
        may_be_repeated_(may_be_repeated),
        follower_(script.gaze ? ports.gaze : nullptr, ports.clock, ports.gaze_correction) {
    std::int64_t interval = 0;
    for (const PlannedTrial& shown : stimuli_of(script, trial)) {
      stimuli_.emplace_back(shown, ++interval, script, progress_, ports, follower_);
    }
    result_.record.slot = trial.slot;
    result_.record.number = number;
    result_.record.wall_naming = wall_naming(own().scene().world.settings().enclosure);
    result_.record.intended_hold_s = own().scene().intended_hold_s;
    result_.record.realised_hold_s = own().scene().realised_hold_s;
    if (script.gaze && ports.gaze != nullptr) {
      result_.record.gaze_source = ports.gaze->source();
      result_.record.imposed_gaze_latency_s = own().imposed_gaze_latency_s();
    }
  }

  AttemptResult run() {
    const bool completed = show_interval() && show_stimuli() && gaze_suffices() && ask_questions();
    collect();
    if (completed) {
      result_.record.outcome = AttemptOutcome::kCompleted;
    } else {
      result_.record.interrupted_by = name_of(result_.interruption);
    }
    return std::move(result_);
  }

 private:
  bool show_interval() {
    ports_.display.restart_grid();
    if (!show_blank(script_.timing.interval_ms)) {
      return false;
    }
    progress_.gaze_was_lost = false;  // the mark is gone when the trial begins
    ports_.recorder.await_saved();
    return true;
  }

  bool show_blank(double duration_ms) {
    const std::int64_t frames = whole_frames(duration_ms / 1e3, ports_.display.refresh_hz());
    for (std::int64_t frame = 0; frame < frames; ++frame) {
      const Flip flip = ports_.display.show(stimuli_.front().blank());
      result_.record.late_untimed_frames += flip.late() ? 1 : 0;
      result_.interruption = ports_.input.interruption();
      if (result_.interruption != Interruption::kNone) {
        return false;
      }
    }
    return true;
  }

  bool show_stimuli() {
    ports_.display.restart_grid();
    for (std::size_t index = 0; index < stimuli_.size(); ++index) {
      if (index > 0) {
        if (!show_blank(find_two_interval(script_)->between_ms())) {
          return false;
        }
        stimuli_[index - 1].take_clicks();  // a late one belongs to what was seen
      }
      result_.interruption = stimuli_[index].show();
      if (result_.interruption != Interruption::kNone) {
        return false;
      }
    }
    return true;
  }

  /// Whether the trial need not be shown again for want of a gaze.
  [[nodiscard]] bool gaze_suffices() const {
    return !may_be_repeated_ ||
           std::none_of(stimuli_.begin(), stimuli_.end(), [&](const Stimulus& stimulus) {
             return gaze_was_lost(script_, stimulus.gaze_lost_share());
           });
  }

  bool ask_questions() {
    if (stimuli_.size() > 1) {
      stimuli_.back().take_clicks();  // before the first is asked for its own
    }
    for (Stimulus& stimulus : stimuli_) {
      stimulus.be_witnessed();
    }
    for (const auto& question : script_.asked) {
      const std::optional<Page> page = question->page(asked_);
      if (!page) {
        continue;
      }
      const Answer answer = ports_.input.ask(*page);
      result_.record.late_untimed_frames += answer.late_frames;
      result_.interruption = answer.interruption;
      if (answer.interruption != Interruption::kNone) {
        return false;
      }
      question->keep(asked_, answer, result_.record);
    }
    return true;
  }

  void collect() {
    AttemptRecord& record = result_.record;
    record.region_covered_share = own().region_covered_share();
    bool depends_on_gaze = false;
    for (Stimulus& stimulus : stimuli_) {
      stimulus.append_to(record);
      depends_on_gaze = depends_on_gaze || stimulus.scene().depends_on_gaze;
      record.gaze_lost_share = std::max(record.gaze_lost_share, stimulus.gaze_lost_share());
    }
    if (depends_on_gaze) {
      record.gaze_latency_p95_ms = gaze_latency_p95_ms(record.steps, record.frames, record.gaze);
    }
  }

  /// The stimulus of the trial's own condition; the other is the standard.
  Stimulus& own() { return stimuli_[static_cast<std::size_t>(asked_.test_interval - 1)]; }

  const Script& script_;
  SessionProgress progress_;  ///< before what refers to it
  AskedTrial asked_;
  const Ports& ports_;
  bool may_be_repeated_;
  GazeFollower follower_;
  std::deque<Stimulus> stimuli_;
  AttemptResult result_;
};

}  // namespace

AttemptResult run_attempt(const PlannedTrial& trial, std::int64_t number, const Script& script,
                          const SessionProgress& progress, const Ports& ports,
                          bool may_be_repeated) {
  return Attempt(trial, number, script, progress, ports, may_be_repeated).run();
}

}  // namespace impetus::inline session
