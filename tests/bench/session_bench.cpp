// A session in a real window for minutes on end: what the screen and the drawing thread had of it.
//
//   impetus_session_bench [--seconds N] [--file STUDY]
//
//   15 bodies at 240 steps a second, detailed about a simulated gaze of 1 kHz, a click a second,
//   the study's writer at work on a real file, a second core kept busy
//
// Needs a display: a lab's, or `xvfb-run -s "-screen 0 1280x1024x24"`.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "experiments/observers/simulated_eye.hpp"
#include "experiments/protocol/screen_file.hpp"
#include "experiments/questions/response_kinds.hpp"
#include "experiments/record/ports.hpp"
#include "experiments/store/study_writer.hpp"
#include "experiments/timing/timing_report.hpp"
#include "experiments/timing/timing_run.hpp"
#include "experiments/window/window.hpp"
#include "tests/bench/memory_watch.hpp"

namespace impetus {
namespace {

constexpr int kBodies = 15;
constexpr double kTrialSeconds = 10.0;  ///< of a stimulus
constexpr double kBetween_s = 1.2;      ///< interval and fixation
constexpr double kSettling_s = 60.0;    ///< in which memory may still grow

struct SessionOptions {
  double seconds{600.0};
  std::filesystem::path file{std::filesystem::temp_directory_path() /
                             "impetus-session-bench.sqlite"};
};

SessionOptions session_options(int count, char** arguments) {
  SessionOptions options;
  for (int i = 1; i < count; ++i) {
    const std::string name = arguments[i];
    const char* value = ++i < count ? arguments[i] : "";
    if (name == "--seconds" && std::atof(value) >= kTrialSeconds) {
      options.seconds = std::atof(value);
    } else if (name == "--file" && *value != '\0') {
      options.file = value;
    } else {
      throw std::invalid_argument("expected --seconds N, of at least 10, or --file STUDY, got " +
                                  name + " " + value);
    }
  }
  return options;
}

/// Takes the memory for so many values before it is watched, so that the notes do not grow.
template <typename Value>
void touch(std::vector<Value>& values, std::size_t count) {
  values.assign(count, Value{});
  values.clear();
}

double ms_of(std::int64_t ns) { return static_cast<double>(ns) / 1e6; }

/// One of the two cores is taken by somebody else.
class BusyCore {
 public:
  BusyCore()
      : thread_([this] {
          volatile double burnt = 1.0;
          while (!stopping_) {
            burnt = burnt * 1.0000001;
          }
        }) {}
  ~BusyCore() {
    stopping_ = true;
    thread_.join();
  }

 private:
  std::atomic<bool> stopping_{false};
  std::thread thread_;
};

/// Shows in the window, and notes when the drawing thread came and went.
class NotedDisplay final : public Display {
 public:
  NotedDisplay(Window& window, const Clock& clock, std::size_t frames)
      : window_(window), clock_(clock) {
    touch(work_ns, frames);
  }

  [[nodiscard]] double refresh_hz() const override { return window_.refresh_hz(); }
  [[nodiscard]] const ScreenGeometry& geometry() const override { return window_.geometry(); }
  void restart_grid() override { window_.restart_grid(); }
  Flip show(const Picture& picture) override {
    const std::int64_t came_ns = clock_.now_ns();
    if (left_ns_ != 0) {
      work_ns.push_back(came_ns - left_ns_);
    }
    const Flip flip = window_.show(picture);
    left_ns_ = clock_.now_ns();
    return flip;
  }

  std::vector<std::int64_t> work_ns;  ///< between two frames: stepping, gaze, clicks, logging

 private:
  Window& window_;
  const Clock& clock_;
  std::int64_t left_ns_{0};
};

/// Nobody sits there; a click comes once a second.
class Clicker final : public Input {
 public:
  Clicker(Window& window, const Clock& clock) : window_(window), clock_(clock) {}

  Answer ask(const Page& /*page*/) override { return {}; }
  Interruption interruption() override { return window_.interruption(); }
  std::vector<ClickRecord> take_clicks() override {
    const std::int64_t now_ns = clock_.now_ns();
    static_cast<void>(window_.take_clicks());
    if (now_ns < next_ns_) {
      return {};
    }
    next_ns_ = now_ns + 1'000'000'000;
    return {{"simulated", now_ns, 0}};
  }

 private:
  Window& window_;
  const Clock& clock_;
  std::int64_t next_ns_{0};
};

/// Hands over to the study's writer, and notes what that takes of the drawing thread.
class NotedRecorder final : public Recorder {
 public:
  NotedRecorder(StudyWriter& writer, const Clock& clock) : writer_(writer), clock_(clock) {}

  void save(AttemptRecord attempt) override {
    note(save_ns, [&] { writer_.save(std::move(attempt)); });
  }
  void save(QuestionRecord answer) override { writer_.save(std::move(answer)); }
  void save(NoteRecord note) override { writer_.save(std::move(note)); }
  void save(ChosenLevel chosen) override { writer_.save(std::move(chosen)); }
  void save(CalibrationRecord calibration) override { writer_.save(std::move(calibration)); }
  void mark_finished() override {}
  void await_saved() override {
    note(await_ns, [&] { writer_.await_saved(); });
  }

  std::vector<std::int64_t> save_ns;
  std::vector<std::int64_t> await_ns;

 private:
  template <typename Work>
  void note(std::vector<std::int64_t>& into, const Work& work) {
    const std::int64_t began_ns = clock_.now_ns();
    work();
    into.push_back(clock_.now_ns() - began_ns);
  }

  StudyWriter& writer_;
  const Clock& clock_;
};

Script bench_script() {
  Script script;
  script.timing = {{500.0, 500.0}, 700.0};
  script.gaze.emplace();
  script.asked = {find_kind("click")->block.read({{"merge_within_ms", 100}})};
  return script;
}

std::vector<StoredTrial> planned_trials(std::int64_t count) {
  std::vector<StoredTrial> trials;
  for (std::int64_t slot = 1; slot <= count; ++slot) {
    trials.push_back({0, slot, TrialPhase::kMain, slot, "{}", 1});
  }
  return trials;
}

SessionFacts bench_facts(const Window& window, const SyncTest& sync) {
  SessionFacts facts;
  facts.build = facts.machine = "benchmark";
  facts.display = window.description();
  facts.simulated = true;
  facts.screen = window.geometry();
  facts.refresh_hz = window.refresh_hz();
  facts.sync = sync;
  facts.sync_overridden = !sync.passed;
  return facts;
}

std::filesystem::path fresh(const std::filesystem::path& file) {
  for (const char* more : {"", "-wal", "-shm"}) {
    std::filesystem::remove(file.string() + more);
  }
  return file;
}

double sum_ms(const std::vector<std::int64_t>& values_ns) {
  std::int64_t sum_ns = 0;
  for (const std::int64_t value_ns : values_ns) {
    sum_ns += value_ns;
  }
  return ms_of(sum_ns);
}

double longest_ms(const std::vector<std::int64_t>& values_ns) {
  return values_ns.empty() ? 0.0 : ms_of(*std::max_element(values_ns.begin(), values_ns.end()));
}

/// What was shown, over all trials.
struct Shown {
  std::vector<double> intervals_ms;  ///< within trials
  std::int64_t frames{0};
  std::int64_t late{0};
  std::int64_t missed_slots{0};

  void add(const AttemptRecord& attempt) {
    std::vector<Flip> flips;
    for (const FrameRecord& frame : attempt.frames) {
      flips.push_back(frame.flip);
      late += frame.flip.late() ? 1 : 0;
      missed_slots += frame.flip.missed_slots;
    }
    frames += static_cast<std::int64_t>(flips.size());
    const std::vector<double> own = impetus::intervals_ms(flips);
    intervals_ms.insert(intervals_ms.end(), own.begin(), own.end());
  }
};

void print(const Shown& shown, const NotedDisplay& display, const NotedRecorder& recorder,
           double period_ms) {
  const Distribution interval = distribution_of(shown.intervals_ms);
  const double frames = static_cast<double>(shown.frames);
  std::printf("frames                     %lld, late %lld (%.3f %%), slots missed %lld\n",
              static_cast<long long>(shown.frames), static_cast<long long>(shown.late),
              100.0 * static_cast<double>(shown.late) / frames,
              static_cast<long long>(shown.missed_slots));
  std::printf(
      "flip interval, ms          median %.2f, 95th %.2f, 99th %.2f, longest %.1f, SD %.3f\n",
      interval.median, interval.p95, interval.p99, interval.largest, interval.sd);
  std::printf("  Psychtoolbox, 600 flips  median 16.67, 95th 16.7-18.0, 99th 19.8-20.6\n");
  std::vector<double> work_ms;
  for (const std::int64_t ns : display.work_ns) {
    work_ms.push_back(ms_of(ns));
  }
  const Distribution work = distribution_of(work_ms);
  std::printf("work between frames, ms    median %.2f, 99th %.2f, longest stall %.1f\n",
              work.median, work.p99, work.largest);
  std::printf(
      "logging, of a frame        %.4f %% (longest hand-over %.3f ms); waiting until it is "
      "saved, between trials, longest %.2f ms\n",
      100.0 * sum_ms(recorder.save_ns) / (frames * period_ms), longest_ms(recorder.save_ns),
      longest_ms(recorder.await_ns));
}

void print(const char* what, const MemoryGrowth& memory) {
  std::printf(
      "%-26s %.1f MiB in the first minute that counts, %.1f in the last: %+.1f KiB a minute\n",
      what, memory.first_MiB, memory.last_MiB, memory.slope_kiB_per_min);
}

void print(const MemoryUse& memory, double left_out_s) {
  std::printf("memory, least of a minute, from %.0f s on; at most %.1f MiB resident\n", left_out_s,
              memory.most_resident_MiB);
  print("  allocated", memory.allocated);
  print("  resident", memory.resident);
}

void run_session_bench(const SessionOptions& options) {
  const SteadyClock clock;
  ShapeLibrary shapes;
  const TimingScenes scenes(kTrialSeconds, shapes);
  static_cast<void>(scenes.stage(timing_trial(kBodies), assumed_screen()));
  Window window(WindowOptions{}, clock);
  ScreenGeometry screen = assumed_screen();
  screen.width_px = screen.height_px = 0;
  window.set_geometry(screen);
  const SyncTest sync = window.sync_test();
  const auto trials = static_cast<std::int64_t>(options.seconds / (kTrialSeconds + kBetween_s)) + 1;
  StudyFile study = StudyFile::open_for_writing(fresh(options.file), "benchmark");
  const Enrolment enrolment =
      enrol(study, "S01", true, {"benchmark", "hash", "{}", "{}"}, 1, planned_trials(trials));
  StudyWriter writer(study, enrolment, bench_facts(window, sync));
  NotedRecorder recorder(writer, clock);
  const auto frames = static_cast<std::size_t>(2.0 * options.seconds * window.refresh_hz());
  NotedDisplay display(window, clock, frames);
  Clicker input(window, clock);
  EyeParameters eye_parameters;
  eye_parameters.sampling_hz = 1000.0;
  SimulatedEye eye(eye_parameters, 1, "S01", clock);
  const Ports ports{display, input, scenes, recorder, &eye, &clock, &clock};
  std::printf("%s\ntrials of %.0f s for %.0f s, %d bodies, gaze at 1 kHz, one core kept busy\n",
              window.description().c_str(), kTrialSeconds, options.seconds, kBodies);
  std::fflush(stdout);
  Shown shown;
  touch(shown.intervals_ms, frames);
  const Script script = bench_script();
  const BusyCore busy;
  MemoryWatch memory;
  const std::int64_t began_ns = clock.now_ns();
  const auto elapsed_s = [&] { return ms_of(clock.now_ns() - began_ns) / 1e3; };
  for (std::int64_t slot = 1; slot <= trials && elapsed_s() < options.seconds; ++slot) {
    PlannedTrial trial = timing_trial(kBodies);
    AttemptResult result = run_attempt(trial, 1, script, {slot, trials, "benchmark"}, ports);
    if (result.interruption != Interruption::kNone) {
      throw std::runtime_error("stopped");
    }
    shown.add(result.record);
    result.record.slot = slot;
    recorder.save(std::move(result.record));
  }
  writer.await_saved();
  const double left_out_s = std::min(kSettling_s, options.seconds / 5.0);
  const MemoryUse use = memory.stop(left_out_s);
  writer.end("finished");
  print(shown, display, recorder, 1e3 / window.refresh_hz());
  print(use, left_out_s);
}

}  // namespace
}  // namespace impetus

int main(int count, char** arguments) {
  try {
    impetus::run_session_bench(impetus::session_options(count, arguments));
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
