// SPDX-License-Identifier: MIT
#include "experiments/session/trial.hpp"

#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include "experiments/session/gaze_follower.hpp"
#include "experiments/session/gaze_latency.hpp"
#include "experiments/session/gaze_loss.hpp"
#include "experiments/session/playback.hpp"
#include "experiments/session/region_coverage.hpp"
#include "experiments/session/whole_frames.hpp"

namespace impetus {
namespace {

std::int64_t nanoseconds(double duration_ms) {
  return static_cast<std::int64_t>(duration_ms * 1e6);
}

StagedScene staged(const PlannedTrial& trial, const Ports& ports) {
  StagedScene scene = ports.scenes.stage(trial, ports.display.geometry());
  if (trial.yoked_trial_id) {
    const GazePath& path = ports.gaze_paths->at(*trial.yoked_trial_id);
    scene.recorded_gaze = std::make_shared<const GazePath>(
        path.seen_from(ports.display.geometry().viewing_distance_m));
  }
  return scene;
}

double imposed_latency_ms(const Script& script, const StagedScene& scene) {
  return script.gaze ? script.gaze->extra_latency_ms + scene.gaze_latency_s * 1e3 : 0.0;
}

const char* name_of(Interruption interruption) {
  return interruption == Interruption::kPauseRequested  ? "pause"
         : interruption == Interruption::kDisplayClosed ? "display closed"
                                                        : kGazeLost;
}

/// Runs the phases of one attempt in order; a phase returns false when it was interrupted.
class Attempt {
 public:
  Attempt(const PlannedTrial& trial, std::int64_t number, const Script& script,
          const SessionProgress& progress, const Ports& ports, bool may_be_repeated)
      : script_(script),
        ports_(ports),
        progress_(progress),
        may_be_repeated_(may_be_repeated),
        playback_(staged(trial, ports), trial.seed, ports.work_clock),
        follower_(script.gaze ? ports.gaze : nullptr, ports.clock,
                  nanoseconds(imposed_latency_ms(script, playback_.scene())),
                  ports.gaze_correction) {
    result_.record.slot = trial.slot;
    result_.record.number = number;
    for (const BodyModel& body : playback_.scene().world.models()) {
      result_.record.body_names.push_back(body.name);
    }
    result_.record.wall_naming = wall_naming(playback_.scene().world.settings().enclosure);
    result_.record.intended_hold_s = playback_.scene().intended_hold_s;
    result_.record.realised_hold_s = playback_.scene().realised_hold_s;
    if (script.gaze && ports.gaze != nullptr) {
      result_.record.gaze_source = ports.gaze->source();
      result_.record.imposed_gaze_latency_s = imposed_latency_ms(script, playback_.scene()) / 1e3;
    }
  }

  AttemptResult run() {
    const bool completed =
        show_interval() && show_fixation() && show_stimulus() && gaze_suffices() && ask_rating();
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
    const std::int64_t frames =
        whole_frames(script_.timing.interval_ms / 1e3, ports_.display.refresh_hz());
    for (std::int64_t frame = 0; frame < frames; ++frame) {
      const Flip flip = ports_.display.show(picture());
      result_.record.late_untimed_frames += flip.late() ? 1 : 0;
      if (interrupted()) {
        return false;
      }
    }
    progress_.gaze_was_lost = false;  // the mark is gone when the trial begins
    ports_.recorder.await_saved();
    return true;
  }

  bool show_fixation() {
    ports_.display.restart_grid();
    Picture cross = picture();
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

  bool show_stimulus() {
    const std::int64_t last_frame =
        whole_frames(playback_.scene().duration_s, ports_.display.refresh_hz());
    fixation_frames_ = static_cast<std::int64_t>(result_.record.frames.size());
    follower_.begin();
    if (script_.clicks) {
      static_cast<void>(ports_.input.take_clicks());
    }
    for (std::int64_t frame = 0; frame <= last_frame; ++frame) {
      const double time_s = static_cast<double>(frame) / ports_.display.refresh_hz();
      playback_.look_at(follower_.look());
      if (!show_timed(picture_at(time_s), FramePhase::kStimulus, time_s)) {
        take_simulation(frame);
        return false;
      }
      take_clicks();
      if (frame == 0) {
        result_.record.onset_ns = result_.record.frames.back().flip.flipped_ns;
        result_.record.clicks.clear();  // made before there was anything to see
      }
    }
    take_simulation(last_frame);
    return true;
  }

  /// Whether the trial need not be shown again for want of a gaze.
  [[nodiscard]] bool gaze_suffices() const {
    return !(may_be_repeated_ && gaze_was_lost(script_, result_.record));
  }

  bool ask_rating() {
    ports_.input.witnessed(result_.record, playback_.scene());
    take_clicks();
    const RatingScale& scale = script_.scale;
    const Answer answer = ports_.input.ask(rating_page());
    result_.record.late_untimed_frames += answer.late_frames;
    result_.interruption = answer.interruption;
    if (answer.interruption != Interruption::kNone) {
      return false;
    }
    result_.record.ratings.push_back({scale.minimum + static_cast<std::int64_t>(answer.choice),
                                      scale.minimum, scale.maximum, scale.best, scale.low_anchor,
                                      scale.high_anchor, answer.device, answer.shown_ns,
                                      answer.arrived_ns, answer.arrival_uncertainty_ns});
    return true;
  }

  [[nodiscard]] Page rating_page() const {
    const RatingScale& scale = script_.scale;
    Page page;
    page.layout = Page::Layout::kScale;
    page.title = scale.question;
    page.low_anchor = scale.low_anchor;
    page.high_anchor = scale.high_anchor;
    page.progress = progress_;
    page.best_choice = static_cast<std::size_t>(scale.best - scale.minimum);
    for (std::int64_t point = scale.minimum; point <= scale.maximum; ++point) {
      page.choices.push_back({std::to_string(point), std::to_string(point)});
    }
    return page;
  }

  [[nodiscard]] Picture picture() const { return with_pointer({}, 0.0); }

  Picture picture_at(double time_s) { return with_pointer(playback_.poses_at(time_s), time_s); }

  [[nodiscard]] Picture with_pointer(const std::vector<Pose>& poses, double time_s) const {
    Picture picture = picture_of(playback_.scene(), poses, time_s, progress_);
    picture.pointer = script_.gaze && ports_.gaze != nullptr && ports_.gaze->is_pointer();
    return picture;
  }

  /// Shows and records one frame of a timed phase; false when that was interrupted.
  bool show_timed(const Picture& frame, FramePhase phase, double time_s) {
    const Flip flip = ports_.display.show(frame);
    const bool goes_on = !interrupted();
    if (result_.interruption != Interruption::kDisplayClosed) {  // else there was no flip
      const auto number = static_cast<std::int64_t>(result_.record.frames.size());
      result_.record.frames.push_back({number, phase, time_s, flip});
      if (ports_.gaze != nullptr) {
        ports_.gaze->shown(frame, flip);
      }
    }
    return goes_on;
  }

  void take_clicks() {
    if (script_.clicks) {
      for (ClickRecord& click : ports_.input.take_clicks()) {
        result_.record.clicks.push_back(std::move(click));
      }
    }
  }

  void take_simulation(std::int64_t last_frame_shown) {
    AttemptRecord& record = result_.record;
    record.steps = playback_.take_steps();
    for (StepRecord& step : record.steps) {
      const std::int64_t first = first_frame(step.step, last_frame_shown);
      step.shown_frame = first < 0 ? -1 : fixation_frames_ + first;
    }
    record.collisions = playback_.take_collisions();
    for (CollisionRecord& collision : record.collisions) {
      collision.first_frame_shown = first_frame(collision.step, last_frame_shown);
    }
    record.gaze = follower_.take_samples();
    if (!record.gaze_source.empty() && record.onset_ns != 0) {
      record.gaze_lost_share =
          gaze_lost_share(record.gaze, record.onset_ns, record.frames.back().flip.flipped_ns);
    }
    record.region_covered_share = mean_covered_share(playback_.scene(), record.steps);
    if (playback_.scene().depends_on_gaze) {
      record.gaze_latency_p95_ms = gaze_latency_p95_ms(record.steps, record.frames, record.gaze);
    }
  }

  /// Of the stimulus, the first frame that shows the step whole; −1 when none did.
  [[nodiscard]] std::int64_t first_frame(std::int64_t step, std::int64_t last_shown) const {
    const double frames_per_step = ports_.display.refresh_hz() / playback_.scene().step_hz;
    const double frame = std::ceil(static_cast<double>(step) * frames_per_step - 1e-9);
    return static_cast<std::int64_t>(frame) <= last_shown ? static_cast<std::int64_t>(frame) : -1;
  }

  bool interrupted() {
    result_.interruption = ports_.input.interruption();
    return result_.interruption != Interruption::kNone;
  }

  const Script& script_;
  const Ports& ports_;
  SessionProgress progress_;
  bool may_be_repeated_;
  Playback playback_;
  GazeFollower follower_;
  std::int64_t fixation_frames_{0};
  AttemptResult result_;
};

}  // namespace

AttemptResult run_attempt(const PlannedTrial& trial, std::int64_t number, const Script& script,
                          const SessionProgress& progress, const Ports& ports,
                          bool may_be_repeated) {
  return Attempt(trial, number, script, progress, ports, may_be_repeated).run();
}

}  // namespace impetus
