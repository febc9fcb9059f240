// The share of a 60 Hz frame that logging takes: on the drawing thread, and on the writer's.
// SPDX-License-Identifier: MIT
#include <benchmark/benchmark.h>

#include <chrono>
#include <filesystem>
#include <functional>

#include "experiments/store/study_writer.hpp"
#include "tests/experiments/fakes.hpp"

namespace impetus {
namespace {

constexpr double kFrameS = 1.0 / 60.0;

SessionFacts any_facts() {
  SessionFacts facts;
  facts.build = facts.machine = facts.display = "benchmark";
  facts.simulated = true;
  facts.screen = assumed_screen();
  facts.refresh_hz = 60.0;
  return facts;
}

/// An attempt at a trial of the causality study as it is handed over, but for its rating.
AttemptRecord recorded_attempt() {
  TestLab lab;
  run_session(lab.protocol.script, short_plan(lab.protocol, 1), {}, lab.ports());
  AttemptRecord attempt = lab.recorder.attempts.back();
  attempt.outcome = AttemptOutcome::kInterrupted;
  attempt.ratings.clear();
  return attempt;
}

/// A study of one trial, whose attempts are written one after another.
class LoggedStudy {
 public:
  explicit LoggedStudy(const AttemptRecord& attempt)
      : study_(StudyFile::open_for_writing(fresh_file(), "benchmark")),
        enrolment_(enrol(study_, "S01", true, {"causality", "hash", "{}", "{}"}, 1,
                         {{0, attempt.slot, TrialPhase::kMain, 1, "{}", 1}})),
        writer_(study_, enrolment_, any_facts()),
        next_(attempt) {
    next_.number = 0;
  }
  ~LoggedStudy() { writer_.await_saved(); }

  AttemptRecord next() {
    ++next_.number;
    return next_;
  }
  StudyWriter& writer() { return writer_; }

 private:
  static std::filesystem::path fresh_file() {
    const auto path = std::filesystem::temp_directory_path() / "impetus-logging-bench.sqlite";
    std::filesystem::remove(path);
    return path;
  }

  StudyFile study_;
  Enrolment enrolment_;
  StudyWriter writer_;
  AttemptRecord next_;
};

/// Time for one trial over the time its frames took, as a percentage.
void report_share(benchmark::State& state, double seconds, const AttemptRecord& attempt) {
  const double shown_s = static_cast<double>(attempt.frames.size()) * kFrameS;
  state.counters["percent_of_frame"] =
      100.0 * seconds / (static_cast<double>(state.iterations()) * shown_s);
}

double seconds_of(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// The drawing thread hands an attempt over and goes on.
void log_on_drawing_thread(benchmark::State& state) {
  const AttemptRecord attempt = recorded_attempt();
  LoggedStudy study(attempt);
  double seconds = 0.0;
  for (auto unused : state) {
    AttemptRecord record = study.next();
    const double took = seconds_of([&] { study.writer().save(std::move(record)); });
    state.SetIterationTime(took);
    seconds += took;
    study.writer().await_saved();
  }
  report_share(state, seconds, attempt);
}
BENCHMARK(log_on_drawing_thread)->Iterations(200)->UseManualTime();

/// The writer's thread inserts it and commits with full synchronisation.
void log_on_writer_thread(benchmark::State& state) {
  const AttemptRecord attempt = recorded_attempt();
  LoggedStudy study(attempt);
  double seconds = 0.0;
  for (auto unused : state) {
    AttemptRecord record = study.next();
    const double took = seconds_of([&] {
      study.writer().save(std::move(record));
      study.writer().await_saved();
    });
    state.SetIterationTime(took);
    seconds += took;
  }
  report_share(state, seconds, attempt);
}
BENCHMARK(log_on_writer_thread)->Iterations(200)->UseManualTime();

}  // namespace
}  // namespace impetus
