// SPDX-License-Identifier: MIT
#include "experiments/commands/replay_viewing.hpp"

#include <nlohmann/json.hpp>
#include <utility>

#include "experiments/commands/commands.hpp"
#include "experiments/commands/replayed_trial.hpp"
#include "experiments/commands/window_size.hpp"
#include "experiments/session/replay_view.hpp"
#include "experiments/session/steady_clock.hpp"
#include "experiments/stage/replay_viewer.hpp"

namespace impetus {
namespace {

struct ViewedAnswer {
  std::string words;
  std::int64_t at_ns{0};
};

/// What is viewed at a time: one stimulus of one attempt.
struct ViewedStimulus {
  StoredAttempt attempt;
  std::int64_t interval{1};
  std::int64_t intervals{1};
  std::int64_t onset_ns{0};
  bool standard{false};
};

std::string title_of(const ViewedStimulus& viewed) {
  const StoredAttempt& attempt = viewed.attempt;
  std::string title = attempt.participant + " · trial " + std::to_string(attempt.trial.slot) +
                      " of " + std::to_string(attempt.trials_planned) + " · ";
  title += attempt.trial.phase == TrialPhase::kPractice ? "practice" : "main";
  title += attempt.number > 1 ? " · attempt " + std::to_string(attempt.number) : "";
  if (viewed.intervals == 1) {
    return title;
  }
  return title + " · interval " + std::to_string(viewed.interval) +
         (viewed.standard ? ", standard" : "");
}

/// What was answered, in the order asked.
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

std::vector<std::string> facts_of(const StoredAttempt& attempt,
                                  const std::vector<ViewedAnswer>& answers) {
  std::vector<std::string> facts;
  const auto condition = nlohmann::json::parse(attempt.trial.condition);
  for (const auto& [factor, level] : condition.items()) {
    facts.push_back(factor + " " + level.dump());
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
void add_marks(StudyFile& study, const ViewedStimulus& viewed,
               const std::vector<ViewedAnswer>& answers, std::vector<TimelineMark>& marks) {
  using Kind = TimelineMark::Kind;
  const auto add = [&](Kind kind, std::int64_t at_ns, const std::string& words) {
    const double at_s = static_cast<double>(at_ns - viewed.onset_ns) / 1e9;
    marks.push_back({kind, at_s, at_s, words});
  };
  if (viewed.interval == viewed.intervals) {
    for (const ViewedAnswer& answer : answers) {
      add(Kind::kResponse, answer.at_ns, answer.words);
    }
  }
  for (const std::int64_t click_ns : load_clicks(study, viewed.attempt.id, viewed.interval)) {
    add(Kind::kClick, click_ns, "");
  }
  for (const LateFrame& frame : load_late_frames(study, viewed.attempt.id, viewed.interval)) {
    marks.push_back({Kind::kLateFrame, frame.shown_time_s, frame.shown_time_s,
                     "late by " + std::to_string(frame.missed_slots)});
  }
}

ReplayView view_of(StudyFile& study, ReplayLibrary& library, const ViewedStimulus& viewed) {
  const StoredAttempt& attempt = viewed.attempt;
  ReplayView view =
      view_of(library.stage(attempt, viewed.interval), library.steps(attempt, viewed.interval));
  const std::vector<ViewedAnswer> answers = answers_of(study, attempt);
  view.title = title_of(viewed);
  view.facts = facts_of(attempt, answers);
  add_marks(study, viewed, answers, view.marks);
  end_with_last_step(view);
  return view;
}

/// Every stimulus that began to be shown.
std::vector<ViewedStimulus> shown_stimuli(StudyFile& study, ReplayLibrary& library,
                                          const std::vector<StoredAttempt>& attempts) {
  std::vector<ViewedStimulus> shown;
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

}  // namespace

int view_attempts(StudyFile& study, const std::vector<StoredAttempt>& attempts,
                  const std::string& window_size) {
  ReplayLibrary library(study);
  const std::vector<ViewedStimulus> shown = shown_stimuli(study, library, attempts);
  if (shown.empty()) {
    throw InputError(study.name() + ": expected a trial that was shown, but there is none");
  }
  const SteadyClock clock;
  Window window(window_options(window_size), clock);
  std::size_t index = 0;
  while (true) {
    window.set_geometry(shown[index].attempt.screen);
    const ViewerExit exit = view_replay(window, view_of(study, library, shown[index]));
    if (exit == ViewerExit::kClosed) {
      return kDone;
    }
    const bool next = exit == ViewerExit::kNextTrial;
    index = next ? std::min(index + 1, shown.size() - 1) : index - (index > 0 ? 1 : 0);
  }
}

}  // namespace impetus
