// SPDX-License-Identifier: MIT
#include "experiments/session/stimulus.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <utility>

#include "experiments/gaze/gaze_loss.hpp"
#include "experiments/gaze/region_source.hpp"
#include "experiments/questions/response_kinds.hpp"
#include "experiments/record/frame_grid.hpp"

namespace impetus::inline session {
namespace {

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

}  // namespace

Stimulus::Stimulus(const PlannedTrial& shown, std::int64_t interval, const Script& script,
                   const SessionProgress& progress, const Ports& ports, GazeFollower& follower)
    : interval_(interval),
      is_asked_(shown.is_asked()),
      seed_(shown.seed),
      script_(script),
      progress_(progress),
      ports_(ports),
      follower_(follower),
      live_(staged(shown, ports), shown.seed, ports.work_clock) {
  record_.slot = shown.slot;
  record_.body_names = body_names(scene().world);
  record_.wall_naming = wall_naming(scene().world.settings().enclosure);
  record_.intended_hold_s = scene().intended_hold_s;
  record_.realised_hold_s = scene().realised_hold_s;
  if (script.gaze && ports.gaze != nullptr) {
    record_.gaze_source = ports.gaze->source();
  }
  if (ports.sounds != nullptr && scene().sound) {
    sounds_.emplace(live_, interval, ports.display.refresh_hz(), *ports.sounds);
  }
}

double Stimulus::imposed_gaze_latency_s() const {
  return script_.gaze ? scene().gaze_latency_s : 0.0;
}

Interruption Stimulus::show() {
  if (show_fixation()) {
    show_scene();
  }
  if (sounds_) {
    sounds_->end();
  }
  return interruption_;
}

bool Stimulus::show_fixation() {
  Picture cross = blank();
  cross.fixation_cross = true;
  const std::int64_t frames = is_asked_ ? fixation_frames(script_.timing.fixation, seed_, interval_,
                                                          ports_.display.refresh_hz())
                                        : 0;
  for (std::int64_t frame = 0; frame < frames; ++frame) {
    if (!show_timed(cross, FramePhase::kFixation, 0.0)) {
      return false;
    }
    sound(frame - frames);
    if (frame == 0) {
      mark(MarkedEvent::kFixation);
    }
  }
  return true;
}

bool Stimulus::show_scene() {
  fixation_frames_ = static_cast<std::int64_t>(record_.frames.size());
  if (script_.gaze && ports_.gaze != nullptr) {
    ports_.gaze->begins(record_.slot);
  }
  follower_.begin(static_cast<std::int64_t>(imposed_gaze_latency_s() * 1e9));
  if (takes_clicks(script_)) {
    static_cast<void>(ports_.input.take_clicks());
  }
  std::int64_t last_frame = last_frame_of(live_);
  for (std::int64_t frame = 0; frame <= last_frame; ++frame) {
    const double time_s = static_cast<double>(frame) / ports_.display.refresh_hz();
    live_.look_at(follower_.look());
    Picture picture = with_pointer(live_.poses_at(time_s), time_s);
    picture.patch_code = patch_code(frame);
    last_frame = std::max(frame, last_frame_of(live_));
    const bool goes_on = show_timed(picture, FramePhase::kStimulus, time_s);
    const bool was_shown = interruption_ != Interruption::kDisplayClosed;
    if (frame == 0 && was_shown) {
      record_.onset_ns = record_.frames.back().flip.flipped_ns;
    }
    if (!goes_on) {
      take_simulation(was_shown ? frame : frame - 1);
      return false;
    }
    mark_frame(frame, last_frame);
    sound(frame);
    if (frame > 0) {
      take_clicks();
    } else if (takes_clicks(script_)) {
      static_cast<void>(ports_.input.take_clicks());  // made before there was anything to see
    }
    if (ends_with_click(script_) && !record_.clicks.empty() && last_frame != frame) {
      last_frame = frame;
      mark(MarkedEvent::kEnd);
    }
  }
  take_simulation(last_frame);
  return true;
}

std::int64_t Stimulus::last_frame_of(const LiveRun& live) const {
  return whole_frames(live.ends_s(), ports_.display.refresh_hz());
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
    if (script_.gaze && ports_.gaze != nullptr) {
      ports_.gaze->shown(frame, flip);
    }
  }
  return interruption_ == Interruption::kNone;
}

Picture Stimulus::with_pointer(const std::vector<Pose>& poses, double time_s) const {
  Picture picture = picture_of(scene(), poses, time_s,
                               script_.progress_during_stimuli ? progress_ : SessionProgress{});
  picture.pointer = script_.gaze && ports_.gaze != nullptr && ports_.gaze->is_pointer();
  return picture;
}

void Stimulus::take_clicks() {
  if (takes_clicks(script_)) {
    for (ClickRecord& click : ports_.input.take_clicks()) {
      click.interval = interval_;
      if (ports_.markers != nullptr && record_.onset_ns != 0) {
        ports_.markers->mark(MarkedEvent::kClick, click.arrived_ns, interval_);
      }
      record_.clicks.push_back(std::move(click));
    }
  }
}

void Stimulus::mark(MarkedEvent event) {
  if (ports_.markers != nullptr) {
    ports_.markers->mark(event, record_.frames.back().flip.flipped_ns, interval_);
  }
}

/// Of the scene from 0 on; of the cross before it, below.
void Stimulus::sound(std::int64_t frame) {
  if (sounds_) {
    sounds_->flipped(frame, record_.frames.back().flip.flipped_ns, live_.collisions());
  }
}

/// What the flip of this frame showed first, or last.
void Stimulus::mark_frame(std::int64_t frame, std::int64_t last_frame) {
  if (ports_.markers == nullptr) {
    return;
  }
  if (frame == 0) {
    mark(MarkedEvent::kOnset);
  }
  const std::vector<CollisionRecord>& collisions = live_.collisions();
  bool shows_contact = false;
  while (marked_collisions_ < collisions.size() &&
         first_frame(collisions[marked_collisions_].step, frame) >= 0) {
    ++marked_collisions_;
    shows_contact = true;
  }
  if (shows_contact) {
    mark(MarkedEvent::kContact);
  }
  if (frame == last_frame) {
    mark(MarkedEvent::kEnd);
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
  if (sounds_) {
    std::vector<SoundRecord> sounds = sounds_->take_records();
    append(record.sounds, sounds);
  }
}

}  // namespace impetus::inline session
