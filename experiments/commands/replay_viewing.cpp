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

std::string title_of(const StoredAttempt& attempt) {
  std::string title = attempt.participant + " · trial " + std::to_string(attempt.trial.slot) +
                      " of " + std::to_string(attempt.trials_planned) + " · ";
  title += attempt.trial.phase == TrialPhase::kPractice ? "practice" : "main";
  return attempt.number > 1 ? title + " · attempt " + std::to_string(attempt.number) : title;
}

std::vector<std::string> facts_of(const StoredAttempt& attempt) {
  std::vector<std::string> facts;
  const auto condition = nlohmann::json::parse(attempt.trial.condition);
  for (const auto& [factor, level] : condition.items()) {
    facts.push_back(factor + " " + level.dump());
  }
  facts.push_back(attempt.rating ? "rated " + std::to_string(*attempt.rating)
                                 : "interrupted, not rated");
  return facts;
}

/// What the participant did, and frames that came late.
void add_marks(StudyFile& study, const StoredAttempt& attempt, std::vector<TimelineMark>& marks) {
  using Kind = TimelineMark::Kind;
  if (attempt.rating) {
    const double at_s = static_cast<double>(attempt.answered_ns - attempt.onset_ns) / 1e9;
    marks.push_back({Kind::kResponse, at_s, at_s, "rated " + std::to_string(*attempt.rating)});
  }
  for (const std::int64_t click_ns : load_clicks(study, attempt.id)) {
    const double at_s = static_cast<double>(click_ns - attempt.onset_ns) / 1e9;
    marks.push_back({Kind::kClick, at_s, at_s, ""});
  }
  for (const LateFrame& frame : load_late_frames(study, attempt.id)) {
    marks.push_back({Kind::kLateFrame, frame.shown_time_s, frame.shown_time_s,
                     "late by " + std::to_string(frame.missed_slots)});
  }
}

ReplayView view_of(StudyFile& study, ReplayLibrary& library, const StoredAttempt& attempt) {
  ReplayView view = view_of(library.stage(attempt), library.steps(attempt));
  view.title = title_of(attempt);
  view.facts = facts_of(attempt);
  add_marks(study, attempt, view.marks);
  end_with_last_step(view);
  return view;
}

}  // namespace

int view_attempts(StudyFile& study, const std::vector<StoredAttempt>& attempts,
                  const std::string& window_size) {
  std::vector<StoredAttempt> shown;
  for (const StoredAttempt& attempt : attempts) {
    if (attempt.onset_ns > 0) {
      shown.push_back(attempt);
    }
  }
  if (shown.empty()) {
    throw InputError(study.name() + ": expected a trial that was shown, but there is none");
  }
  ReplayLibrary library(study);
  const SteadyClock clock;
  Window window(window_options(window_size), clock);
  std::size_t index = 0;
  while (true) {
    window.set_geometry(shown[index].screen);
    const ViewerExit exit = view_replay(window, view_of(study, library, shown[index]));
    if (exit == ViewerExit::kClosed) {
      return kDone;
    }
    const bool next = exit == ViewerExit::kNextTrial;
    index = next ? std::min(index + 1, shown.size() - 1) : index - (index > 0 ? 1 : 0);
  }
}

}  // namespace impetus
