// `impetus replay`: simulates every recorded trial again and compares each step's hash.
// SPDX-License-Identifier: MIT
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "experiments/commands/commands.hpp"
#include "experiments/commands/progress_line.hpp"
#include "experiments/commands/replays/replay_levels.hpp"
#include "experiments/commands/replays/replay_with.hpp"
#include "experiments/provenance/build_name.hpp"
#include "experiments/run/collision_truth.hpp"
#include "experiments/settings/input_error.hpp"
#include "experiments/store/study_reader.hpp"
#include "experiments/study/replay_comparison.hpp"
#include "experiments/study/replay_library.hpp"
#include "experiments/tables/text_table.hpp"

#ifdef IMPETUS_WINDOW
#include "experiments/commands/window_size.hpp"
#include "experiments/record/ports.hpp"
#include "experiments/viewers/replays/replay_viewer.hpp"
#include "experiments/viewing/viewed_stimuli.hpp"
#endif

namespace impetus::inline commands {
namespace {

// `impetus replay --truth`: fills the study's table of what was wrong with each collision.

/// The truth of an interval's collisions; tells and returns nothing when it diverges.
std::optional<std::vector<MeasuredCollision>> measured(StudyFile& study, ReplayLibrary& library,
                                                       const StoredAttempt& attempt,
                                                       std::int64_t interval) {
  const StagedScene scene = library.stage(attempt, interval);
  std::vector<std::string> names;
  for (const DrawnBody& look : scene.looks) {
    names.push_back(look.name);
  }
  std::vector<MeasuredCollision> truths;
  const std::vector<StoredCollision> collisions =
      load_collisions(study, attempt.id, names, interval);
  const ReplayResult result = replay(
      scene, library.steps(attempt, interval),
      [&](std::int64_t step, const World& world, const StepReport&) {
        for (const StoredCollision& collision : collisions) {
          if (collision.step == step) {
            truths.push_back({collision.id, measure_truth(scene, world, collision.bodies, step)});
          }
        }
      });
  if (result.divergence) {
    std::printf("trial %lld diverges at step %lld: its collisions are left without truth%s\n",
                static_cast<long long>(attempt.trial_id),
                static_cast<long long>(result.divergence->step), why_divergent(attempt).c_str());
    return std::nullopt;
  }
  return truths;
}

/// Of all intervals of an attempt.
std::optional<std::vector<MeasuredCollision>> measured(StudyFile& study, ReplayLibrary& library,
                                                       const StoredAttempt& attempt) {
  std::vector<MeasuredCollision> all;
  for (std::int64_t interval = 1; interval <= library.intervals(attempt); ++interval) {
    const auto truths = measured(study, library, attempt, interval);
    if (!truths) {
      return std::nullopt;
    }
    all.insert(all.end(), truths->begin(), truths->end());
  }
  return all;
}

/// Measures every recorded collision of the attempts and stores it; returns the exit status. A
/// trial that diverges is named and left without truth. `study` must be open for writing.
int fill_truth(StudyFile& study, const std::vector<StoredAttempt>& attempts) {
  ReplayLibrary library(study);
  const bool terminal = isatty(STDERR_FILENO) != 0;
  int status = kDone;
  std::size_t count = 0;
  for (std::size_t done = 0; done < attempts.size(); ++done) {
    const auto truths = measured(study, library, attempts[done]);
    if (!truths) {
      status = kFound;
      continue;
    }
    store_truths(study, *truths);
    count += truths->size();
    if (terminal) {
      std::fprintf(stderr, "\rtrial %zu of %zu", done + 1, attempts.size());
    }
  }
  if (terminal) {
    std::fprintf(stderr, "\n");
  }
  std::printf("%zu collisions measured in %zu trials\n", count, attempts.size());
  return status;
}

#ifdef IMPETUS_WINDOW

// `impetus replay --view`: recorded trials in the viewer's window.

/// An answer as the viewer shows it, and when it was given.
struct ViewedAnswer {
  std::string words;
  std::int64_t at_ns{0};
};

/// A stimulus that began to be shown.
struct ShownStimulus {
  StoredAttempt attempt;
  std::int64_t interval{1};
  std::int64_t intervals{1};
  std::int64_t onset_ns{0};
  bool standard{false};
};

std::string title_of(const ShownStimulus& shown) {
  const StoredAttempt& attempt = shown.attempt;
  std::string title = attempt.participant + " · trial " + std::to_string(attempt.trial.slot) +
                      " of " + std::to_string(attempt.trials_planned) + " · ";
  title += name_of(attempt.trial.phase);
  title += attempt.number > 1 ? " · attempt " + std::to_string(attempt.number) : "";
  if (shown.intervals == 1) {
    return title;
  }
  return title + " · interval " + std::to_string(shown.interval) +
         (shown.standard ? ", standard" : "");
}

/// What was answered.
std::vector<ViewedAnswer> answers_of(StudyFile& study, const StoredAttempt& attempt) {
  std::vector<ViewedAnswer> answers;
  if (attempt.rating) {
    answers.push_back({"rated " + std::to_string(*attempt.rating), attempt.answered_ns});
  }
  for (const StoredResponse& response : load_responses(study, attempt.id)) {
    answers.push_back({response.kind + (response.timed_out        ? ": no answer in time"
                                        : response.answer.empty() ? ": left empty"
                                                                  : " " + response.answer),
                       response.arrived_ns});
  }
  return answers;
}

std::vector<std::string> condition_of(const StoredAttempt& attempt) {
  std::vector<std::string> levels;
  const auto condition = nlohmann::json::parse(attempt.trial.condition);
  for (const auto& [factor, level] : condition.items()) {
    levels.push_back(factor + " " + (level.is_string() ? level.get<std::string>() : level.dump()));
  }
  return levels;
}

std::vector<std::string> facts_of(const StoredAttempt& attempt,
                                  const std::vector<ViewedAnswer>& answers) {
  std::vector<std::string> facts{"trial " + std::to_string(attempt.trial_id) + " of the study"};
  for (std::string& level : condition_of(attempt)) {
    facts.push_back(std::move(level));
  }
  for (const ViewedAnswer& answer : answers) {
    facts.push_back(answer.words);
  }
  if (!attempt.completed) {
    facts.push_back(answers.empty() ? "interrupted, not rated" : "interrupted");
  }
  return facts;
}

/// What the participant did, and frames that came late.
std::vector<TimelineMark> marks_of(StudyFile& study, const ShownStimulus& shown,
                                   const std::vector<ViewedAnswer>& answers,
                                   const std::vector<TimedGaze>& gaze) {
  using Kind = TimelineMark::Kind;
  std::vector<TimelineMark> marks;
  const auto add = [&](Kind kind, std::int64_t at_ns, const std::string& words) {
    const double at_s = static_cast<double>(at_ns - shown.onset_ns) / 1e9;
    marks.push_back({kind, at_s, at_s, words});
  };
  if (shown.interval == shown.intervals) {
    for (const ViewedAnswer& answer : answers) {
      add(Kind::kResponse, answer.at_ns, answer.words);
    }
  }
  for (const std::int64_t click_ns : load_clicks(study, shown.attempt.id, shown.interval)) {
    add(Kind::kClick, click_ns, "");
  }
  for (const LateFrame& frame : load_late_frames(study, shown.attempt.id, shown.interval)) {
    marks.push_back({Kind::kLateFrame, frame.shown_time_s, frame.shown_time_s,
                     "late by " + std::to_string(frame.missed_slots)});
  }
  for (const LostStretch& lost : lost_stretches(gaze)) {
    marks.push_back({Kind::kGazeLost, std::max(0.0, lost.begin_s), lost.end_s, ""});
  }
  return marks;
}

/// Every stimulus that began to be shown.
std::vector<ShownStimulus> shown_stimuli(StudyFile& study, ReplayLibrary& library,
                                         const std::vector<StoredAttempt>& attempts) {
  std::vector<ShownStimulus> shown;
  for (const StoredAttempt& attempt : attempts) {
    const std::int64_t intervals = library.intervals(attempt);
    for (std::int64_t interval = 1; interval <= intervals; ++interval) {
      if (const auto onset_ns = load_onset(study, attempt.id, interval)) {
        shown.push_back({attempt, interval, intervals, *onset_ns,
                         intervals > 1 && library.shows_standard(attempt, interval)});
      }
    }
  }
  return shown;
}

/// The stimuli of a study, from which the viewer opens one after the other.
class StudyStimuli final : public ViewedStimuli {
 public:
  StudyStimuli(StudyFile& study, ReplayLibrary& library, std::vector<ShownStimulus> shown,
               Window& window)
      : study_(study), library_(library), shown_(std::move(shown)), window_(window) {}

  [[nodiscard]] std::size_t count() const override { return shown_.size(); }

  [[nodiscard]] StimulusLine line(std::size_t index) override {
    const ShownStimulus& shown = shown_[index];
    std::string words = title_of(shown);
    for (const std::string& level : condition_of(shown.attempt)) {
      words += " · " + level;
    }
    words += shown.attempt.rating ? " · rated " + std::to_string(*shown.attempt.rating) : "";
    words += shown.attempt.completed ? "" : " · interrupted";
    return {shown.attempt.trial_id, words};
  }

  [[nodiscard]] ViewedStimulus load(std::size_t index, const Progress& progress) override {
    const ShownStimulus& shown = shown_[index];
    const StoredAttempt& attempt = shown.attempt;
    window_.set_geometry(attempt.screen);
    const std::vector<ViewedAnswer> answers = answers_of(study_, attempt);
    std::vector<TimedGaze> gaze =
        timed_gaze(load_gaze(study_, attempt.id), load_gaze_correction(study_, attempt.id),
                   shown.interval, shown.onset_ns);
    std::vector<TimelineMark> marks = marks_of(study_, shown, answers, gaze);
    library_.tell(progress);
    ViewedStimulus viewed{title_of(shown),
                          facts_of(attempt, answers),
                          library_.stage(attempt, shown.interval),
                          library_.steps(attempt, shown.interval),
                          std::move(marks),
                          std::move(gaze),
                          {std::filesystem::path(study_.name()).stem().string(), attempt.trial_id,
                           attempt.number, shown.interval}};
    library_.tell({});
    return viewed;
  }

 private:
  StudyFile& study_;
  ReplayLibrary& library_;
  std::vector<ShownStimulus> shown_;
  Window& window_;
};

/// Plays the attempts one by one until the viewer is closed; returns the exit status.
int view_attempts(StudyFile& study, const std::vector<StoredAttempt>& attempts,
                  const std::string& window_size) {
  ReplayLibrary library(study);
  std::vector<ShownStimulus> shown = shown_stimuli(study, library, attempts);
  if (shown.empty()) {
    throw InputError(study.name() + ": expected a trial that was shown, but there is none");
  }
  const SteadyClock clock;
  Window window(window_options(window_size), clock);
  StudyStimuli stimuli(study, library, std::move(shown), window);
  view_replays(window, stimuli, clock);
  return kDone;
}

#endif

/// What `impetus replay` was asked for.
struct ReplayOptions {
  std::string study;
  std::optional<std::int64_t> trial;
  std::string participant;
  bool view{false};
  bool truth{false};
  std::string window_size;
  ReplayWithOptions what_if;
};

std::vector<StoredAttempt> chosen_attempts(StudyFile& study, const ReplayOptions& options) {
  std::vector<StoredAttempt> attempts = load_attempts(study);
  std::erase_if(attempts, [&](const StoredAttempt& attempt) {
    return (options.trial && attempt.trial_id != *options.trial) ||
           (!options.participant.empty() && attempt.participant != options.participant);
  });
  if (attempts.empty() && (options.trial || !options.participant.empty())) {
    throw InputError(study.name() + ": expected a recorded trial" +
                     (options.trial ? " " + std::to_string(*options.trial) : "") +
                     (options.participant.empty() ? "" : " of " + options.participant) +
                     ", but there is none");
  }
  return attempts;
}

void print(const StoredAttempt& attempt, const std::string& what) {
  std::printf("trial %lld (%s, slot %lld, attempt %lld): %s\n",
              static_cast<long long>(attempt.trial_id), printable(attempt.participant).c_str(),
              static_cast<long long>(attempt.trial.slot), static_cast<long long>(attempt.number),
              printable(what).c_str());
}

/// Whether the attempt is as it was recorded; what is not is told.
bool replays(ReplayComparison& comparison, const StoredAttempt& attempt) {
  const std::string problem = comparison.problem_of(attempt);
  for (const std::string& taken_out : comparison.taken_out()) {
    print(attempt, taken_out);
  }
  if (!problem.empty()) {
    print(attempt, problem);
  }
  return problem.empty();
}

int compare_all(StudyFile& study, const std::vector<StoredAttempt>& attempts) {
  using Seconds = std::chrono::duration<double>;
  ReplayLibrary library(study);
  ReplayComparison comparison(study, library);
  std::int64_t diverged = 0;
  const auto start = std::chrono::steady_clock::now();
  for (const StoredAttempt& attempt : attempts) {
    diverged += replays(comparison, attempt) ? 0 : 1;
  }
  diverged += compare_levels(study, attempts, library);
  const double took_s = Seconds(std::chrono::steady_clock::now() - start).count();
  const double times = comparison.simulated_s() / took_s;
  std::printf("%zu trials, %lld steps, %.*f times real time, %lld divergent\n", attempts.size(),
              static_cast<long long>(comparison.steps()), times < 10.0 ? 1 : 0, times,
              static_cast<long long>(diverged));
  return diverged == 0 ? kDone : kFound;
}

void require_one_purpose(const ReplayOptions& options) {
  const bool asks = !options.what_if.with.empty();
  if (asks && (options.view || options.truth)) {
    throw InputError(std::string("--with: expected neither --view nor --truth beside it, got ") +
                     (options.view ? "--view" : "--truth"));
  }
  if (!asks && !(options.what_if.csv_file.empty() && options.what_if.json_file.empty())) {
    throw InputError(std::string(options.what_if.csv_file.empty() ? "--json" : "--out") +
                     ": expected --with beside it, which is missing");
  }
}

int replay_study(const ReplayOptions& options) {
  const BuildingLine told;
  require_one_purpose(options);
#ifndef IMPETUS_WINDOW
  if (options.view) {
    throw InputError("--view: this build has no window");
  }
#endif
  StudyFile study = options.truth ? StudyFile::open_for_writing(options.study, build_name())
                                  : StudyFile::open_for_reading(options.study);
  return while_reading(study, [&] {
    const std::vector<StoredAttempt> attempts = chosen_attempts(study, options);
#ifdef IMPETUS_WINDOW
    if (options.view) {
      return view_attempts(study, attempts, options.window_size);
    }
#endif
    if (!options.what_if.with.empty()) {
      return replay_with(study, attempts, options.what_if);
    }
    return options.truth ? fill_truth(study, attempts) : compare_all(study, attempts);
  });
}

}  // namespace

void add_replay(CLI::App& app, Command& chosen) {
  const auto [command, options] =
      add_command<ReplayOptions>(app, chosen, replay_study, "replay",
                                 "Simulate every recorded trial again and compare each step");
  command->add_option("study", options->study, "Study file")->required();
  command->add_option("--trial", options->trial,
                      "Only this trial (the column `trial` of the views)");
  command->add_option("--participant", options->participant, "Only this participant's trials");
  command->add_flag("--view", options->view, "Play the trials in a window");
  command->add_flag("--truth", options->truth,
                    "Measure each collision's gap and hidden share and store them");
  command->add_option("--with", options->what_if.with, words_of_setting_keys())
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  command->add_option("--out", options->what_if.csv_file,
                      "Of --with: write a CSV file, a row for each stimulus");
  command->add_option("--json", options->what_if.json_file,
                      "Of --with: write a JSON file, with every collision");
  command->add_option("--window", options->window_size, "WIDTHxHEIGHT instead of fullscreen");
}

}  // namespace impetus::inline commands
