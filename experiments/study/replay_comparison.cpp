// SPDX-License-Identifier: MIT
#include "experiments/study/replay_comparison.hpp"

#include <SQLiteCpp/Database.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <tuple>

#include "experiments/questions/level_value.hpp"
#include "experiments/record/wall_names.hpp"
#include "experiments/run/frame_poses.hpp"
#include "experiments/run/live_run.hpp"
#include "experiments/store/attempt_rows.hpp"
#include "experiments/store/migration.hpp"
#include "experiments/store/rows.hpp"
#include "experiments/store/step_rows.hpp"

namespace impetus::inline study {
namespace {

constexpr const char* kSteps =
    "SELECT 'step ' || step, * FROM step WHERE attempt_id = ? ORDER BY interval, step";
constexpr const char* kCollisions =
    "SELECT 'the collision of ' || body_a || ' and ' || body_b || ' at step ' || step, * "
    "FROM collision WHERE attempt_id = ? ORDER BY interval, step, id";

/// But where a row is, which frames showed what it tells, and digests, which the hash stands for.
bool is_compared(const std::string& column) {
  constexpr std::array<std::string_view, 5> kOthers{"id", "attempt_id", "first_frame",
                                                    "shown_frame", "digests"};
  return std::find(kOthers.begin(), kOthers.end(), column) == kOthers.end();
}

/// Whether two values of a column are the same, of an attempt of an old schema, which left columns
/// out, or not. Angles come from functions that processors round differently in their last bits,
/// and older formats named walls by axes.
bool is_same(const SQLite::Column& recorded, const SQLite::Column& again, bool old) {
  if (recorded.isNull() || again.isNull()) {
    return recorded.isNull() && (old || again.isNull());
  }
  if (again.isFloat() || recorded.isFloat()) {
    constexpr double kOfTheLarger = 1e-9;
    const double one = recorded.getDouble();
    const double other = again.getDouble();
    return one == other ||
           std::abs(one - other) <= kOfTheLarger * std::max(std::abs(one), std::abs(other));
  }
  const std::string one = recorded.getString();
  const std::string other = again.getString();
  const std::optional<std::int32_t> wall = wall_named(one);
  return one == other || (wall && wall == wall_named(other));
}

/// "" or " of interval 2", where there are two.
std::string of_interval(std::int64_t interval, std::int64_t intervals) {
  return intervals == 1 ? "" : " of interval " + std::to_string(interval);
}

std::string words_of(const Divergence& divergence, const std::string& where) {
  std::string words = "diverges at step " + std::to_string(divergence.step) + where + ", ";
  if (divergence.body.empty()) {
    return words + "in the hash alone";
  }
  words += "body " + divergence.body + ", " + divergence.field;
  if (divergence.named_at != divergence.step) {
    words += ", as step " + std::to_string(divergence.named_at) + " tells";
  }
  return words;
}

/// The first step that is missing among those that are there; "" when none is.
std::string missing_step(const std::vector<StepRecord>& recorded, const std::string& where) {
  for (std::size_t i = 0; i < recorded.size(); ++i) {
    if (recorded[i].step != static_cast<std::int64_t>(i)) {
      return "step " + std::to_string(i) + where + " is missing";
    }
  }
  return "";
}

/// The last step that a completed attempt's interval needs: for its last frame, or, where nobody
/// was shown it, for its end. None: the attempt was interrupted, or no frame was shown.
std::optional<std::int64_t> last_needed(StudyFile& study, const StoredAttempt& attempt,
                                        std::int64_t interval, const StagedScene& scene,
                                        double ends_s) {
  if (!attempt.completed) {
    return std::nullopt;
  }
  if (attempt.onset_ns == 0) {
    return last_shown_step(scene, ends_s);
  }
  const auto last = load_last_frame(study, attempt.id, interval);
  return last ? std::optional(last_shown_step(scene, last->shown_time_s)) : std::nullopt;
}

/// What differs between two rows with the same columns, of which the first says where they are; ""
/// when nothing does.
std::string difference(const SQLite::Statement& recorded, const SQLite::Statement& again,
                       bool old) {
  for (int i = 1; i < again.getColumnCount(); ++i) {
    const std::string column = again.getColumnName(i);
    const SQLite::Column was = recorded.getColumn(column.c_str());
    const SQLite::Column is = again.getColumn(i);
    if (is_compared(column) && !is_same(was, is, old)) {
      return recorded.getColumn(0).getString() + ": " + column + " is " +
             (was.isNull() ? "nothing" : was.getString()) + ", simulated again " +
             (is.isNull() ? "nothing" : is.getString());
    }
  }
  return "";
}

/// The same of all rows of a query, in both databases.
std::string difference(SQLite::Database& study, std::int64_t attempt_id, SQLite::Database& replay,
                       std::int64_t replayed_id, const char* query) {
  // Before schema 5 no attempt says when it was saved, and columns that came later are empty.
  const bool old =
      load_value<std::int64_t>(study, "SELECT 1 FROM attempt WHERE id = ? AND saved_utc IS NULL",
                               attempt_id)
          .has_value();
  SQLite::Statement recorded(study, query);
  SQLite::Statement again(replay, query);
  recorded.bind(1, attempt_id);
  again.bind(1, replayed_id);
  while (true) {
    const bool was = recorded.executeStep();
    const bool is = again.executeStep();
    if (!was || !is) {
      return was  ? recorded.getColumn(0).getString() + " is recorded, but does not come again"
             : is ? again.getColumn(0).getString() + " is not recorded"
                  : "";
    }
    if (std::string words = difference(recorded, again, old); !words.empty()) {
      return words;
    }
  }
}

/// The same of the freeze at contact.
std::string hold_difference(SQLite::Database& study, std::int64_t attempt_id,
                            const AttemptRecord& again) {
  constexpr double kMost_ms = 1e-6;
  const auto [intended_ms, realised_ms] = load_row<double, double>(
      study, "SELECT intended_hold_ms, realised_hold_ms FROM attempt WHERE id = ?", attempt_id);
  for (const auto& [name, was_ms, is_ms] :
       {std::tuple("intended", intended_ms, 1e3 * again.intended_hold_s),
        std::tuple("realised", realised_ms, 1e3 * again.realised_hold_s)}) {
    if (std::abs(was_ms - is_ms) > kMost_ms) {
      return std::string("its ") + name + " hold is " + to_text(LevelValue(was_ms)) +
             " ms, staged again " + to_text(LevelValue(is_ms)) + " ms";
    }
  }
  return "";
}

bool is_named(const std::optional<Divergence>& divergence) {
  return divergence && !divergence->body.empty();
}

}  // namespace

ReplayComparison::ReplayComparison(StudyFile& study, ReplayLibrary& library)
    : study_(study),
      library_(library),
      again_(":memory:", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE) {
  create_tables_and_views(again_);
}

std::string ReplayComparison::problem_of(const StoredAttempt& attempt) {
  taken_out_.clear();
  AttemptRecord again;
  for (std::int64_t interval = 1; interval <= library_.intervals(attempt); ++interval) {
    if (std::string problem = simulate(attempt, interval, again); !problem.empty()) {
      return problem + why_divergent(attempt);
    }
  }
  if (std::string words = hold_difference(study_.database(), attempt.id, again); !words.empty()) {
    return words;
  }
  again_.exec("DELETE FROM step; DELETE FROM collision");
  constexpr std::int64_t kAttempt = 1;
  insert_steps(again_, kAttempt, again.steps);
  insert_collisions(again_, kAttempt, again);
  for (const char* rows : {kSteps, kCollisions}) {
    std::string words = difference(study_.database(), attempt.id, again_, kAttempt, rows);
    if (!words.empty()) {
      return words + why_divergent(attempt);
    }
  }
  return "";
}

std::string ReplayComparison::simulate(const StoredAttempt& attempt, std::int64_t interval,
                                       AttemptRecord& again) {
  const std::string where = of_interval(interval, library_.intervals(attempt));
  const std::vector<StepRecord> recorded = library_.steps(attempt, interval);
  if (std::string missing = missing_step(recorded, where); !missing.empty()) {
    return missing;
  }
  RunningReplay running(library_.stage(attempt, interval), recorded);
  again.body_names = body_names(running.scene().world);
  again.wall_naming = wall_naming(running.scene().world.settings().enclosure);
  if (!library_.shows_standard(attempt, interval)) {
    again.intended_hold_s = running.scene().intended_hold_s;
    again.realised_hold_s = running.scene().realised_hold_s;
  }
  while (!running.done() && !is_named(running.result().divergence)) {
    const StepRecord& then = recorded[static_cast<std::size_t>(running.next_step())];
    const StepReport& report = running.next();
    again.steps.push_back(record_step(then.step, then.gaze, report, false));
    again.steps.back().interval = interval;
    for (const CollisionReport& collision : report.collisions) {
      if (collision.began) {
        again.collisions.push_back(record_collision(running.scene_run(), then.gaze, collision));
        again.collisions.back().interval = interval;
      }
    }
  }
  const ReplayResult& result = running.result();
  steps_ += result.steps;
  simulated_s_ += static_cast<double>(result.steps) / running.scene().step_hz;
  for (const TakenOut& body : result.taken_out) {
    taken_out_.push_back("body " + body.body + " is taken out at step " +
                         std::to_string(body.step) + where + ": its " + body.field +
                         " is not finite");
  }
  if (result.divergence) {
    return words_of(*result.divergence, where);
  }
  const auto needed = last_needed(study_, attempt, interval, running.scene(), result.ends_s);
  const std::int64_t last = static_cast<std::int64_t>(recorded.size()) - 1;
  return needed && last != *needed ? "expected steps up to " + std::to_string(*needed) + where +
                                         ", the last one there is " + std::to_string(last)
                                   : "";
}

}  // namespace impetus::inline study
