// SPDX-License-Identifier: MIT
#include "experiments/session/trial.hpp"

#include <cmath>
#include <string>
#include <utility>

#include "experiments/session/playback.hpp"

namespace impetus {
namespace {

/// Runs the phases of one attempt in order; a phase returns false when it was interrupted.
class Attempt {
 public:
  Attempt(const PlannedTrial& trial, std::int64_t number, const Script& script,
          const Progress& progress, const Ports& ports)
      : script_(script),
        ports_(ports),
        progress_(progress),
        unlimited_(kUnlimitedTests),
        playback_(ports.scenes.stage(trial, ports.display.geometry()), unlimited_) {
    result_.record.slot = trial.slot;
    result_.record.number = number;
    for (const BodyModel& body : playback_.scene().world.models()) {
      result_.record.body_names.push_back(body.name);
    }
    result_.record.intended_hold_s = playback_.scene().intended_hold_s;
    result_.record.realised_hold_s = playback_.scene().realised_hold_s;
  }

  AttemptResult run() {
    const bool completed = show_interval() && show_fixation() && show_stimulus() && ask_rating();
    if (completed) {
      result_.record.outcome = AttemptOutcome::kCompleted;
    }
    return std::move(result_);
  }

 private:
  bool show_interval() {
    ports_.display.restart_grid();
    const std::int64_t frames = whole_frames(script_.timing.interval_ms / 1e3);
    for (std::int64_t frame = 0; frame < frames; ++frame) {
      const Flip flip = ports_.display.show(picture());
      result_.record.late_untimed_frames += flip.late() ? 1 : 0;
      if (interrupted()) {
        return false;
      }
    }
    ports_.recorder.await_saved();
    return true;
  }

  bool show_fixation() {
    ports_.display.restart_grid();
    Picture cross = picture();
    cross.fixation_cross = true;
    const std::int64_t frames = whole_frames(script_.timing.fixation_ms / 1e3);
    for (std::int64_t frame = 0; frame < frames; ++frame) {
      if (!show_timed(cross, FramePhase::kFixation, 0.0)) {
        return false;
      }
    }
    return true;
  }

  bool show_stimulus() {
    const std::int64_t last_frame = whole_frames(playback_.scene().duration_s);
    for (std::int64_t frame = 0; frame <= last_frame; ++frame) {
      const double time_s = static_cast<double>(frame) / ports_.display.refresh_hz();
      if (!show_timed(picture_at(time_s), FramePhase::kStimulus, time_s)) {
        take_simulation(frame);
        return false;
      }
      if (frame == 0) {
        result_.record.onset_ns = result_.record.frames.back().flip.flipped_ns;
      }
    }
    take_simulation(last_frame);
    return true;
  }

  bool ask_rating() {
    ports_.input.witnessed(result_.record, playback_.scene());
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

  [[nodiscard]] Picture picture() const {
    Picture blank;
    blank.viewer = playback_.scene().viewer;
    blank.progress = progress_;
    return blank;
  }

  Picture picture_at(double time_s) {
    Picture scene = picture();
    const std::vector<Pose> poses = playback_.poses_at(time_s);
    for (std::size_t body = 0; body < poses.size(); ++body) {
      scene.bodies.push_back({poses[body], playback_.scene().looks[body]});
    }
    return scene;
  }

  /// Shows and records one frame of a timed phase; false when that was interrupted.
  bool show_timed(const Picture& frame, FramePhase phase, double time_s) {
    const Flip flip = ports_.display.show(frame);
    const bool goes_on = !interrupted();
    if (result_.interruption != Interruption::kDisplayClosed) {  // else there was no flip
      const auto number = static_cast<std::int64_t>(result_.record.frames.size());
      result_.record.frames.push_back({number, phase, time_s, flip});
    }
    return goes_on;
  }

  void take_simulation(std::int64_t last_frame_shown) {
    const double frames_per_step = ports_.display.refresh_hz() / playback_.scene().step_hz;
    result_.record.steps = playback_.take_steps();
    result_.record.collisions = playback_.take_collisions();
    for (CollisionRecord& collision : result_.record.collisions) {
      const double frame = std::ceil(static_cast<double>(collision.step) * frames_per_step - 1e-9);
      const auto first = static_cast<std::int64_t>(frame);
      collision.first_frame_shown = first <= last_frame_shown ? first : -1;
    }
  }

  bool interrupted() {
    result_.interruption = ports_.input.interruption();
    return result_.interruption != Interruption::kNone;
  }

  /// The frames that cover a duration; whole for every duration that a protocol's check passed.
  [[nodiscard]] std::int64_t whole_frames(double duration_s) const {
    return static_cast<std::int64_t>(std::ceil(duration_s * ports_.display.refresh_hz() - 1e-6));
  }

  const Script& script_;
  const Ports& ports_;
  const Progress& progress_;
  FixedWork unlimited_;
  Playback playback_;
  AttemptResult result_;
};

}  // namespace

AttemptResult run_attempt(const PlannedTrial& trial, std::int64_t number, const Script& script,
                          const Progress& progress, const Ports& ports) {
  return Attempt(trial, number, script, progress, ports).run();
}

}  // namespace impetus
