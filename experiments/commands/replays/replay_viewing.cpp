// SPDX-License-Identifier: MIT
#include "experiments/commands/replays/replay_viewing.hpp"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <utility>

#include "experiments/commands/commands.hpp"
#include "experiments/commands/window_size.hpp"
#include "experiments/record/ports.hpp"
#include "experiments/study/replay_library.hpp"
#include "experiments/viewers/replays/replay_viewer.hpp"
#include "experiments/viewing/viewed_stimuli.hpp"

namespace impetus::inline commands {
namespace {

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

}  // namespace

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

}  // namespace impetus::inline commands
