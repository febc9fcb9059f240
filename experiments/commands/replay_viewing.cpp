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

std::vector<TimelineMark> marks_of(StudyFile& study, const StoredAttempt& attempt,
                                   const StagedScene& scene) {
  using Kind = TimelineMark::Kind;
  std::vector<TimelineMark> marks;
  if (scene.contact_s > 0.0) {
    marks.push_back({Kind::kContact, scene.contact_s, scene.contact_s, "contact"});
  }
  if (scene.realised_hold_s > 0.0) {
    marks.push_back(
        {Kind::kHold, scene.contact_s, scene.contact_s + scene.realised_hold_s, "imposed hold"});
  }
  if (attempt.rating) {
    const double at_s = static_cast<double>(attempt.answered_ns - attempt.onset_ns) / 1e9;
    marks.push_back({Kind::kResponse, at_s, at_s, "rated " + std::to_string(*attempt.rating)});
  }
  for (const std::int64_t click_ns : load_clicks(study, attempt.id)) {
    const double at_s = static_cast<double>(click_ns - attempt.onset_ns) / 1e9;
    marks.push_back({Kind::kResponse, at_s, at_s, "click"});
  }
  for (const LateFrame& frame : load_late_frames(study, attempt.id)) {
    marks.push_back({Kind::kLateFrame, frame.shown_time_s, frame.shown_time_s,
                     "late by " + std::to_string(frame.missed_slots)});
  }
  return marks;
}

/// An interrupted trial has no more than was shown: neither time nor marks after it.
void stop_where_it_was_interrupted(ReplayView& view) {
  const double shown_s = static_cast<double>(view.states.size() - 1) / view.step_hz;
  if (shown_s < view.duration_s) {
    view.duration_s = shown_s;
    std::erase_if(view.marks, [&](const TimelineMark& mark) { return mark.begin_s > shown_s; });
  }
}

ReplayView view_of(StudyFile& study, ReplayLibrary& library, const StoredAttempt& attempt) {
  StagedScene scene = library.stage(attempt);
  ReplayView view;
  view.title = title_of(attempt);
  view.facts = facts_of(attempt);
  view.viewer = scene.viewer;
  view.looks = scene.looks;
  view.enclosure = scene.world.settings().enclosure;
  view.step_hz = scene.step_hz;
  view.duration_s = scene.duration_s;
  view.marks = marks_of(study, attempt, scene);
  const ReplayResult result = replay(std::move(scene), library.steps(attempt),
                                     [&view](std::int64_t, const World& world, const StepReport&) {
                                       view.states.push_back(world.states());
                                     });
  stop_where_it_was_interrupted(view);
  view.agrees = !result.divergence;
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
