// SPDX-License-Identifier: MIT
#include "experiments/study/showing_check.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <string>
#include <tuple>
#include <vector>

#include "experiments/questions/level_value.hpp"
#include "experiments/questions/two_interval.hpp"
#include "experiments/store/rows.hpp"
#include "experiments/study/embedded_places.hpp"

namespace impetus::inline study {
namespace {

constexpr std::int64_t kNoFrame = -1;  // none showed it

constexpr const char* kShownCollisions =
    "SELECT 'the collision of ' || body_a || ' and ' || body_b, step, coalesce(first_frame, -1) "
    "FROM collision WHERE attempt_id = ? AND interval = ? ORDER BY id";

/// One stimulus of a completed attempt, as far as it was shown and simulated.
struct ShownInterval {
  std::int64_t attempt_id{0};
  std::int64_t protocol_id{0};
  std::string place;
  std::int64_t interval{1};
  std::string condition;  ///< of the trial, JSON
  std::uint64_t seed{0};  ///< of the trial
  double refresh_hz{0.0};
};

/// A frame of the stimulus.
struct ShownFrame {
  std::int64_t frame{0};  ///< of the attempt
  double time_s{0.0};     ///< of the stimulus
};

/// What a row says of the frame that showed it first.
struct FirstShown {
  std::string what;
  std::int64_t step{0};
  std::int64_t frame{kNoFrame};
};

/// Steps a second of the stimulus. Throws std::exception when the trial is none of the protocol's,
/// or has no such interval.
double step_hz(const ShownInterval& shown, const Protocol& protocol) {
  PlannedTrial trial;
  trial.seed = shown.seed;
  trial.condition = condition_from_json(nlohmann::json::parse(shown.condition), protocol.design);
  const std::vector<PlannedTrial> stimuli = stimuli_of(protocol.script, trial);
  if (shown.interval > static_cast<std::int64_t>(stimuli.size())) {
    throw std::runtime_error("its protocol shows no interval " + std::to_string(shown.interval));
  }
  return scene_under(protocol, stimuli[static_cast<std::size_t>(shown.interval - 1)].condition)
      .at(nlohmann::json::json_pointer("/engine/step_hz"))
      .get<double>();
}

/// Compares what is stored of an interval with what its frames need and show.
class IntervalCheck {
 public:
  IntervalCheck(SQLite::Database& database, const ShownInterval& shown, double step_hz)
      : database_(database),
        shown_(shown),
        step_hz_(step_hz),
        frames_(load_as<ShownFrame, std::int64_t, double>(
            database,
            "SELECT frame, shown_time_s FROM frame WHERE attempt_id = ? AND interval = ? "
            "AND phase = 'stimulus' ORDER BY frame",
            shown.attempt_id, shown.interval)) {}

  /// The first problem; "": none.
  [[nodiscard]] std::string problem() const {
    const std::vector<FirstShown> steps = load_first_shown(
        "SELECT 'step ' || step, step, coalesce(shown_frame, -1) FROM step "
        "WHERE attempt_id = ? AND interval = ? ORDER BY step");
    std::string problem = length_problem(steps.empty() ? kNoFrame : steps.back().step);
    if (problem.empty()) {
      problem = frame_problem(steps, frames_.front().frame);
    }
    return problem.empty() ? frame_problem(load_first_shown(kShownCollisions), 0) : problem;
  }

 private:
  [[nodiscard]] std::vector<FirstShown> load_first_shown(const std::string& query) const {
    return load_as<FirstShown, std::string, std::int64_t, std::int64_t>(
        database_, query, shown_.attempt_id, shown_.interval);
  }

  /// As LiveRun steps: to the step that the last frame falls on, or the next.
  [[nodiscard]] std::string length_problem(std::int64_t last_step) const {
    constexpr double kOfAStep = 1e-9;
    const double needed = std::ceil(frames_.back().time_s * step_hz_ - kOfAStep);
    return static_cast<double>(last_step) == needed
               ? ""
               : "its last frame shows step " + to_text(LevelValue(needed)) +
                     ", the last one there is " + std::to_string(last_step);
  }

  /// Of what is said to be first shown by another frame than by its time; the stimulus's frames are
  /// counted from `first` on.
  [[nodiscard]] std::string frame_problem(const std::vector<FirstShown>& rows,
                                          std::int64_t first) const {
    const auto words = [](std::int64_t frame) {
      return frame == kNoFrame ? std::string("no frame") : "frame " + std::to_string(frame);
    };
    for (const FirstShown& row : rows) {
      const std::size_t place = first_showing(row.step);
      const std::int64_t frame =
          place < frames_.size() ? first + static_cast<std::int64_t>(place) : kNoFrame;
      if (row.frame != frame) {
        return row.what + " is said to be first shown by " + words(row.frame) +
               ", by its time it is by " + words(frame);
      }
    }
    return "";
  }

  /// The first frame of the stimulus that shows the step whole; as many as there are: none does.
  [[nodiscard]] std::size_t first_showing(std::int64_t step) const {
    const double begins_s = static_cast<double>(step) / step_hz_;
    const double hair_s = 1e-9 / shown_.refresh_hz;
    const auto first = std::partition_point(
        frames_.begin(), frames_.end(),
        [&](const ShownFrame& frame) { return frame.time_s < begins_s - hair_s; });
    return static_cast<std::size_t>(first - frames_.begin());
  }

  SQLite::Database& database_;
  const ShownInterval& shown_;
  double step_hz_;
  std::vector<ShownFrame> frames_;
};

}  // namespace

Failures wrong_showings(StudyFile& study, const ProtocolShelf& shelf) {
  SQLite::Database& database = study.database();
  Failures failures;
  for (const ShownInterval& shown : load_as<ShownInterval, std::int64_t, std::int64_t, std::string,
                                            std::int64_t, std::string, std::uint64_t, double>(
           database,
           std::string(kPlacesSql) +
               "SELECT DISTINCT shown.id, protocol_id, shown.place, frame.interval, condition, "
               "trial.seed, refresh_hz FROM frame JOIN shown ON shown.id = attempt_id "
               "JOIN session ON session.id = session_id JOIN trial ON trial.id = trial_id "
               "JOIN enrolled ON enrolled.id = shown.enrolment_id "
               "WHERE outcome <> 'interrupted' AND frame.phase = 'stimulus' "
               "ORDER BY shown.id, frame.interval")) {
    const Protocol* protocol = shelf.find(shown.protocol_id);
    if (protocol == nullptr) {
      continue;
    }
    std::string problem;
    try {
      problem = IntervalCheck(database, shown, step_hz(shown, *protocol)).problem();
    } catch (const SQLite::Exception&) {
      throw;
    } catch (const std::exception& error) {
      problem = std::string("how long it is cannot be told: ") + error.what();
    }
    if (!problem.empty()) {
      failures.push_back(shown.place + ": " + problem);
    }
  }
  return failures;
}

}  // namespace impetus::inline study
