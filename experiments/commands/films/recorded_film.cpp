// SPDX-License-Identifier: MIT
#include "experiments/commands/films/recorded_film.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "experiments/gaze/gaze_trail.hpp"
#include "experiments/settings/input_error.hpp"
#include "experiments/store/rows.hpp"
#include "experiments/study/replay_library.hpp"

namespace impetus::inline commands {
namespace {

/// Half an hour at 100 Hz: no trial is as long, a damaged study may say so.
constexpr double kMostRefreshes = 200000.0;

[[noreturn]] void refuse_trial(const StudyFile& study, const StoredAttempt& attempt,
                               const std::string& sentence) {
  throw InputError(study.name() + ": trial " + std::to_string(attempt.trial_id) + " " + sentence);
}

void require_same(const StudyFile& study, const StoredAttempt& attempt,
                  const FilmedStimulus& stimulus) {
  const ReplayResult result = replay(stimulus.scene, stimulus.steps);
  if (result.divergence) {
    refuse_trial(study, attempt,
                 "diverges at step " + std::to_string(result.divergence->step) +
                     " when it is replayed, so a film would not be what was shown" +
                     why_divergent(attempt));
  }
}

/// Of an interval; none: its scene was not shown.
std::vector<TimedGaze> samples_of(StudyFile& study, const StoredAttempt& attempt,
                                  std::int64_t interval) {
  const auto onset_ns = load_onset(study, attempt.id, interval);
  return onset_ns ? timed_gaze(load_gaze(study, attempt.id),
                               load_gaze_correction(study, attempt.id), interval, *onset_ns)
                  : std::vector<TimedGaze>{};
}

/// What went with the pictures, in words.
nlohmann::ordered_json left_out(StudyFile& study, const StoredAttempt& attempt,
                                const Script& script) {
  nlohmann::ordered_json names = nlohmann::ordered_json::array();
  if (script.progress_during_stimuli) {
    names.push_back("the bar of progress");
  }
  if (load_value<std::string>(study.database(), "SELECT gaze_source FROM attempt WHERE id = ?",
                              attempt.id) == "mouse") {
    names.push_back("the mouse pointer");
  }
  if (load_value<std::int64_t>(study.database(), "SELECT count(*) FROM sound WHERE attempt_id = ?",
                               attempt.id) > 0) {
    names.push_back("the sound");
  }
  return names;
}

nlohmann::ordered_json head_of(StudyFile& study, const StoredAttempt& attempt,
                               const Script& script) {
  return {{"study", study.name()},
          {"trial", attempt.trial_id},
          {"participant", attempt.participant},
          {"slot", attempt.trial.slot},
          {"attempt", attempt.number},
          {"completed", attempt.completed},
          {"condition", nlohmann::ordered_json::parse(attempt.trial.condition)},
          {"refresh_hz", attempt.refresh_hz},
          {"left_out", left_out(study, attempt, script)}};
}

}  // namespace

StoredAttempt filmed_attempt(StudyFile& study, std::int64_t trial,
                             std::optional<std::int64_t> number) {
  std::vector<StoredAttempt> attempts = load_attempts(study);
  std::erase_if(attempts, [&](const StoredAttempt& attempt) {
    return attempt.trial_id != trial || (number && attempt.number != *number);
  });
  if (attempts.empty()) {
    throw InputError(study.name() + ": expected a recorded trial " + std::to_string(trial) +
                     (number ? " with an attempt " + std::to_string(*number) : "") +
                     ", but there is none");
  }
  const auto completed =
      std::find_if(attempts.begin(), attempts.end(),
                   [](const StoredAttempt& attempt) { return attempt.completed; });
  return completed == attempts.end() ? attempts.back() : *completed;
}

RecordedFilm recorded_film(StudyFile& study, const StoredAttempt& attempt) {
  ReplayLibrary library(study);
  Film film;
  film.refresh_hz = attempt.refresh_hz;
  film.patch = load_patch_corner(study, attempt.id);
  film.frames = load_frames(study, attempt.id);
  if (film.frames.empty()) {
    refuse_trial(study, attempt, "has no frames that were shown");
  }
  if (refreshes(film) > kMostRefreshes) {
    refuse_trial(study, attempt, "has flips that lie too far apart to be those of a trial");
  }
  const std::int64_t intervals = std::min(library.intervals(attempt), film.frames.back().interval);
  for (std::int64_t interval = 1; interval <= intervals; ++interval) {
    film.stimuli.push_back({library.stage(attempt, interval), library.steps(attempt, interval),
                            samples_of(study, attempt, interval)});
    require_same(study, attempt, film.stimuli.back());
  }
  return {std::move(film), head_of(study, attempt, library.protocol(attempt.protocol_id).script)};
}

}  // namespace impetus::inline commands
