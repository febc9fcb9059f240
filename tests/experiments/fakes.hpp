// A session's surroundings for tests: a participant who follows a list, a recorder in memory, the
// shipped protocol, all in virtual time.
// SPDX-License-Identifier: MIT
#pragma once

#include <deque>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "experiments/files/protocol_files.hpp"
#include "experiments/observers/headless_lab.hpp"
#include "experiments/protocol/protocol_file.hpp"
#include "experiments/protocol/protocol_scenes.hpp"
#include "experiments/protocol/screen_file.hpp"
#include "experiments/session/session.hpp"
#include "tests/places/places.hpp"

namespace impetus {

inline std::filesystem::path source_file(const std::string& path) {
  return std::filesystem::path(source_folder()) / path;
}

inline Protocol causality() { return load_protocol(source_file("protocols/causality.json")); }

/// Answers every page with its first choice, unless told otherwise; interrupts when told.
class ScriptedInput final : public Input {
 public:
  explicit ScriptedInput(VirtualClock& clock) : clock_(&clock) {}

  Answer ask(const Page& page) override {
    titles.push_back(page.title);
    Answer answer = on_page ? on_page(page) : Answer{};
    answer.fields.resize(page.fields.size());
    answer.device = "key";
    answer.shown_ns = clock_->now_ns();
    clock_->advance_by(500'000'000);
    answer.arrived_ns = clock_->now_ns();
    return answer;
  }

  Interruption interruption() override {
    ++frames;
    return on_frame ? on_frame(frames) : Interruption::kNone;
  }

  std::vector<ClickRecord> take_clicks() override {
    return on_clicks ? on_clicks() : std::vector<ClickRecord>{};
  }

  std::function<Answer(const Page&)> on_page;
  std::function<std::vector<ClickRecord>()> on_clicks;
  std::function<Interruption(std::int64_t frame)> on_frame;
  std::vector<std::string> titles;
  std::int64_t frames{0};

 private:
  VirtualClock* clock_;
};

/// A gaze that is where `at` says, sampled `age_ns` before each call; lost where it says nothing.
class ScriptedGaze final : public Gaze {
 public:
  ScriptedGaze(const VirtualClock& clock, std::int64_t age_ns) : clock_(&clock), age_ns_(age_ns) {}

  [[nodiscard]] std::string source() const override { return "scripted"; }
  std::vector<GazeSample> take_samples() override {
    const std::int64_t taken_ns = clock_->now_ns() - age_ns_;
    const Fixation place = at ? at(taken_ns) : Fixation{};
    return {{taken_ns, place, place ? GazeLoss::kNone : GazeLoss::kBlink}};
  }

  std::function<Fixation(std::int64_t taken_ns)> at;

 private:
  const VirtualClock* clock_;
  std::int64_t age_ns_;
};

/// Keeps everything; `awaited` is how many attempts had been handed over at each await.
class MemoryRecorder final : public Recorder {
 public:
  void save(AttemptRecord attempt) override { attempts.push_back(std::move(attempt)); }
  void save(QuestionRecord answer) override { answers.push_back(std::move(answer)); }
  void save(NoteRecord note) override { notes.push_back(std::move(note)); }
  void save(ChosenLevel chosen) override { levels.push_back(std::move(chosen)); }
  void save(CalibrationRecord calibration) override {
    calibrations.push_back(std::move(calibration));
  }
  void mark_finished() override { finished = true; }
  void await_saved() override { awaited.push_back(attempts.size()); }

  std::vector<AttemptRecord> attempts;
  std::vector<QuestionRecord> answers;
  std::vector<NoteRecord> notes;
  std::vector<ChosenLevel> levels;
  std::vector<CalibrationRecord> calibrations;
  std::vector<std::size_t> awaited;
  bool finished{false};
};

/// A headless display that also keeps the pictures it was shown.
class WatchedDisplay final : public Display {
 public:
  WatchedDisplay(VirtualClock& clock, double refresh_hz)
      : display_(clock, refresh_hz, assumed_screen()) {}

  [[nodiscard]] double refresh_hz() const override { return display_.refresh_hz(); }
  [[nodiscard]] const ScreenGeometry& geometry() const override { return display_.geometry(); }
  void restart_grid() override { display_.restart_grid(); }
  Flip show(const Picture& picture) override {
    pictures.push_back(picture);
    return display_.show(picture);
  }

  std::vector<Picture> pictures;

 private:
  HeadlessDisplay display_;
};

/// Everything a session runs on, at 60 Hz.
struct TestLab {
  explicit TestLab(double refresh_hz = 60.0, Protocol study = causality())
      : display(clock, refresh_hz), input(clock), protocol(std::move(study)) {}

  [[nodiscard]] Ports ports() { return {display, input, scenes, recorder, gaze, &clock, &clock}; }

  VirtualClock clock;
  WatchedDisplay display;
  ScriptedInput input;
  MemoryRecorder recorder;
  Gaze* gaze{nullptr};
  Protocol protocol;
  ProtocolScenes scenes{protocol, 0.0};
};

/// The shipped design cut down to a few trials: two practice, the cells of one repetition.
inline Plan short_plan(const Protocol& protocol, std::size_t main_trials) {
  Design design = protocol.design;
  design.repetitions = 1;
  design.practice.resize(2);
  Plan plan = make_plan(design, {protocol.name, "P01", 1});
  plan.resize(2 + main_trials);
  return plan;
}

}  // namespace impetus
