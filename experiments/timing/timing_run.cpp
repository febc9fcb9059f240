// SPDX-License-Identifier: MIT
#include "experiments/timing/timing_run.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "experiments/gaze/gaze_latency.hpp"
#include "experiments/record/frame_grid.hpp"
#include "experiments/run/live_run.hpp"
#include "experiments/scenes/scene_file.hpp"
#include "experiments/session/trial.hpp"
#include "experiments/tables/number_text.hpp"
#include "experiments/timing/embedded_creatures.hpp"
#include "experiments/timing/embedded_l_blocks.hpp"

namespace impetus::inline timing {
namespace {

constexpr int kMostBlocks = 100;

constexpr int kParts = 6;  // and one where sounds were asked for
constexpr int kGazeBodies = 15;

/// Keeps nothing: what is measured is in the attempt.
class NoRecorder final : public Recorder {
 public:
  void save(AttemptRecord /*attempt*/) override {}
  void save(QuestionRecord /*answer*/) override {}
  void save(NoteRecord /*note*/) override {}
  void save(ChosenLevel /*chosen*/) override {}
  void save(CalibrationRecord /*calibration*/) override {}
  void mark_finished() override {}
  void await_saved() override {}
};

/// After every flip, looks what the window system holds where the patch is.
class WatchedPatch final : public Display {
 public:
  explicit WatchedPatch(TimingLab& lab) : lab_(lab) {}

  [[nodiscard]] double refresh_hz() const override { return lab_.display().refresh_hz(); }
  [[nodiscard]] const ScreenGeometry& geometry() const override {
    return lab_.display().geometry();
  }
  [[nodiscard]] bool has_patch() const override { return true; }
  void restart_grid() override { lab_.display().restart_grid(); }
  Flip show(const Picture& picture) override {
    const Flip flip = lab_.display().show(picture);
    sightings.push_back({picture.patch_code, lab_.read_patch()});
    return flip;
  }

  std::vector<PatchSighting> sightings;

 private:
  TimingLab& lab_;
};

std::vector<Flip> flips_of(const std::vector<FrameRecord>& frames) {
  std::vector<Flip> flips;
  flips.reserve(frames.size());
  for (const FrameRecord& frame : frames) {
    flips.push_back(frame.flip);
  }
  return flips;
}

FlipSeries flip_series(int bodies, const std::vector<Flip>& flips, double nominal_hz) {
  FlipSeries run{bodies, flip_statistics(flips, nominal_hz), intervals_ms(flips), {}};
  for (const Flip& flip : flips) {
    run.missed_slots.push_back(flip.missed_slots);
  }
  return run;
}

GazeRun gaze_run(const AttemptRecord& record, const std::string& clock) {
  GazeRun run{record.gaze_source,
              gaze_latencies_ms(record.steps, record.frames, record.gaze),
              record.gaze_lost_share.value_or(0.0),
              clock,
              {}};
  for (std::size_t i = 1; i < record.gaze.size(); ++i) {
    run.intervals_ms.push_back(
        static_cast<double>(record.gaze[i].taken_ns - record.gaze[i - 1].taken_ns) / 1e6);
  }
  return run;
}

MarkerRun marker_run(const std::vector<MarkerRecord>& markers, const std::string& address) {
  MarkerRun run{address, 0, {}};
  for (const MarkerRecord& marker : markers) {
    if (marker.written_ns) {
      run.delays_ms.push_back(static_cast<double>(*marker.written_ns - marker.event_ns) / 1e6);
    } else {
      ++run.lost;
    }
  }
  return run;
}

constexpr std::int64_t kTicks_ns = 250'000'000;       // from one sound to the next
constexpr std::int64_t kSoundAhead_ns = 100'000'000;  // as a session hands foreseen ones over
constexpr double kLastSounds_s = 0.5;                 // until the last have left, too

/// A tone of a few milliseconds.
SoundTask tick() {
  SoundTask task;
  task.kind = SoundKind::kTone;
  task.duration_ms = 10.0;
  return task;
}

/// A sound that was asked for.
struct AskedSound {
  std::int64_t number{0};
  std::int64_t at_ns{0};
  bool at_once{false};
};

SoundRun sound_run(const std::vector<AskedSound>& asked, Sounds& sounds, std::string device) {
  SoundRun run{std::move(device)};
  for (const AskedSound& sound : asked) {
    const std::optional<std::int64_t> realised_ns = sounds.realised_ns(sound.number);
    if (realised_ns) {
      (sound.at_once ? run.at_once_ms : run.off_ms)
          .push_back(static_cast<double>(*realised_ns - sound.at_ns) / 1e6);
    } else {
      ++run.lost;
    }
  }
  return run;
}

Script timed_script() {
  Script script;
  script.timing = {{500.0, 500.0}, 0.0};
  script.gaze.emplace();
  return script;
}

/// Every part returns whether it came to its end.
class TimingRun {
 public:
  TimingRun(TimingLab& lab, const Scenes& scenes, const TimingTask& task, const TellPart& tell)
      : lab_(lab), scenes_(scenes), task_(task), tell_(tell) {}

  std::optional<TimingReport> run() {
    report_.sync = lab_.sync_test();
    const bool whole = measure_blank() && measure_sounds() && measure_bodies(1) &&
                       measure_bodies(kGazeBodies) && measure_bodies(250) && measure_input() &&
                       check_patch();
    return whole ? std::optional(std::move(report_)) : std::nullopt;
  }

 private:
  void begin(const std::string& part) {
    const int parts = lab_.sounds() == nullptr ? kParts : kParts + 1;
    const double left_s = (parts - done_) * task_.seconds;
    const std::string text = printed("Part %d of %d: %s; %.0f s to go. Esc stops.", done_ + 1,
                                     parts, part.c_str(), std::ceil(left_s));
    progress_ = {done_++, parts, text};
    tell_(progress_);
  }

  [[nodiscard]] std::int64_t frames() const { return whole_frames(task_.seconds, nominal_hz()); }
  [[nodiscard]] double nominal_hz() const { return lab_.display().refresh_hz(); }

  bool show_blanks(double seconds, const std::function<void(const Flip&)>& shown) {
    const std::int64_t frames = whole_frames(seconds, nominal_hz());
    Picture blank;
    blank.progress = progress_;
    blank.viewer = viewer_at(lab_.display().geometry(), 0.0);
    lab_.display().restart_grid();
    for (std::int64_t frame = 0; frame < frames; ++frame) {
      shown(lab_.display().show(blank));
      if (lab_.input().interruption() != Interruption::kNone) {
        return false;
      }
    }
    return true;
  }

  bool measure_blank() {
    begin("a blank picture");
    std::vector<Flip> flips;
    const bool whole = show_blanks(task_.seconds, [&](const Flip& flip) { flips.push_back(flip); });
    report_.runs.push_back(flip_series(0, flips, nominal_hz()));
    return whole;
  }

  bool measure_sounds() {
    if (lab_.sounds() == nullptr) {
      return true;
    }
    begin("sounds");
    Sounds& sounds = *lab_.sounds();
    const SoundTask task = tick();
    sounds.prepare(task);
    std::vector<AskedSound> asked;
    std::int64_t next_ns = 0;
    const auto ask = [&](const Flip& flip) {
      if (flip.flipped_ns < next_ns) {
        return;
      }
      const bool at_once = asked.size() % 2 == 1;
      const std::int64_t at_ns = flip.flipped_ns + (at_once ? 0 : kSoundAhead_ns);
      asked.push_back({sounds.play(task, at_ns, task.loudness), at_ns, at_once});
      next_ns = flip.flipped_ns + kTicks_ns;
    };
    const bool whole =
        show_blanks(task_.seconds, ask) && show_blanks(kLastSounds_s, [](const Flip& /*flip*/) {});
    report_.sounds = sound_run(asked, sounds, lab_.sound_device());
    return whole;
  }

  /// One trial of the session's own; its record, unless it was interrupted.
  std::optional<AttemptRecord> shown(int bodies, Display& display) {
    NoRecorder nobody;
    Ports ports{display, lab_.input(), scenes_, nobody, &lab_.gaze(), &lab_.clock(), &lab_.clock()};
    ports.markers = lab_.markers();
    AttemptResult result = run_attempt(timing_trial(bodies), 1, timed_script(), progress_, ports);
    if (result.interruption != Interruption::kNone) {
      return std::nullopt;
    }
    return std::move(result.record);
  }

  bool measure_bodies(int bodies) {
    begin(count_of(bodies, "body", "bodies"));
    const auto record = shown(bodies, lab_.display());
    if (record) {
      report_.runs.push_back(flip_series(bodies, flips_of(record->frames), nominal_hz()));
    }
    if (record && bodies == kGazeBodies) {
      report_.gaze = gaze_run(*record, lab_.gaze_clock());
      report_.markers = marker_run(record->markers, lab_.marker_address());
    }
    return record.has_value();
  }

  bool measure_input() {
    begin("keys and mouse, which are better left alone");
    LiveRun live(scenes_.stage(timing_trial(kGazeBodies), lab_.display().geometry()), 1,
                 &lab_.clock());
    std::int64_t frame = 0;
    bool interrupted = false;
    lab_.display().restart_grid();
    const InputTrace trace = lab_.try_input([&] {
      const double time_s = static_cast<double>(frame) / nominal_hz();
      static_cast<void>(
          lab_.display().show(picture_of(live.scene(), live.poses_at(time_s), time_s, progress_)));
      interrupted = lab_.input().interruption() != Interruption::kNone;
      return ++frame < frames() && !interrupted;
    });
    for (const InputRoute route : {InputRoute::kQueue, InputRoute::kWindowSystem}) {
      for (const InputDevice device : {InputDevice::kKey, InputDevice::kMouse}) {
        report_.inputs.push_back(input_delay(trace, device, route));
      }
    }
    return !interrupted;
  }

  bool check_patch() {
    begin("the coded patch");
    report_.content.corner = name_of(task_.corner);
    report_.content.readable = lab_.can_read_patch();
    lab_.show_patch(task_.corner);
    WatchedPatch display(lab_);
    const bool whole = shown(kGazeBodies, display).has_value();
    report_.content.check = check_content(display.sightings);
    return whole;
  }

  TimingLab& lab_;
  const Scenes& scenes_;
  const TimingTask& task_;
  const TellPart& tell_;
  int done_{0};
  SessionProgress progress_;
  TimingReport report_;
};

}  // namespace

PlannedTrial timing_trial(int bodies) {
  PlannedTrial trial;
  trial.slot = bodies;
  trial.condition = {{"bodies", static_cast<double>(bodies)}};
  trial.seed = 1;
  return trial;
}

StagedScene TimingScenes::stage(const PlannedTrial& trial, const ScreenGeometry& screen) const {
  const bool crowd = trial.slot > kMostBlocks;
  nlohmann::json scene = nlohmann::json::parse(crowd ? kCreaturesSceneText : kLBlocksSceneText);
  scene["crowd"]["count"] = trial.slot;
  scene["duration_s"] = duration_s_;
  if (!crowd) {
    scene["engine"]["region"]["kind"] = "tracked";
  }
  return build_scene(scene, screen, kUnroundedHold, *shapes_, "timing", trial.seed);
}

StagedScene TimingScenes::stage_demonstration(const std::string& id,
                                              const ScreenGeometry& /*screen*/) const {
  throw std::logic_error("a timing report has no demonstration " + id);
}

std::optional<TimingReport> run_timing(TimingLab& lab, const Scenes& scenes, const TimingTask& task,
                                       const TellPart& tell) {
  return TimingRun(lab, scenes, task, tell).run();
}

}  // namespace impetus::inline timing
