// SPDX-License-Identifier: MIT
#include "experiments/store/attempt_rows.hpp"

#include <sqlite3.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <variant>

#include "experiments/gaze/gaze_latency.hpp"
#include "experiments/store/rows.hpp"
#include "experiments/store/step_rows.hpp"

namespace impetus::inline store {
namespace {

std::optional<double> in_ms(const std::optional<double>& seconds) {
  return seconds ? std::optional(*seconds * 1e3) : std::nullopt;
}

std::int64_t insert_attempt_row(SQLite::Database& database, const AttemptOwner& owner,
                                const AttemptRecord& attempt) {
  const bool is_late = attempt.gaze_latency_p95_ms.value_or(0.0) > kMarkedGazeLatency_ms;
  return insert_row(
      database, "attempt",
      {{"trial_id", owner.trial_id},
       {"session_id", owner.session_id},
       {"number", attempt.number},
       {"outcome", attempt.outcome == AttemptOutcome::kCompleted ? "completed" : "interrupted"},
       {"onset_ns", attempt.onset_ns},
       {"intended_hold_ms", attempt.intended_hold_s * 1e3},
       {"realised_hold_ms", attempt.realised_hold_s * 1e3},
       {"timed_frames", attempt.frames.size()},
       {"late_timed_frames", late_frames(attempt)},
       {"late_untimed_frames", attempt.late_untimed_frames},
       {"sync_overridden", owner.sync_overridden},
       {"gaze_source", text_or_null(attempt.gaze_source)},
       {"gaze_late", is_late},
       {"interrupted_by", text_or_null(attempt.interrupted_by)},
       {"gaze_latency_p95_ms", attempt.gaze_latency_p95_ms},
       {"region_covered_share", attempt.region_covered_share},
       {"gaze_lost_share", attempt.gaze_lost_share},
       {"imposed_gaze_latency_ms", in_ms(attempt.imposed_gaze_latency_s)},
       {"saved_utc", Now()}});
}

/// What one axis of a body's imposed spin is; none: none was imposed.
std::optional<double> spin_along(const std::optional<ImposedSpin>& spin, Vector3 ImposedSpin::*body,
                                 int axis) {
  return spin ? std::optional((*spin.*body)[axis]) : std::nullopt;
}

}  // namespace

void insert_collisions(SQLite::Database& database, std::int64_t id, const AttemptRecord& attempt) {
  RowInsert rows(database, "collision");
  for (const CollisionRecord& collision : attempt.collisions) {
    const CollisionReport& report = collision.report;
    const TouchPoint& touch = report.contact.touch;
    const std::optional<ImposedSpin>& spin = collision.imposed_spin;
    const std::int64_t frame = collision.first_frame_shown;
    const auto name = [&](std::int32_t body) {
      return body_or_wall_name(body, attempt.body_names, attempt.wall_naming);
    };
    rows.insert({{"attempt_id", id},
                 {"step", collision.step},
                 {"body_a", name(report.bodies.a)},
                 {"body_b", name(report.bodies.b)},
                 {"level", report.level},
                 {"stopped", name_of(report.stop)},
                 {"point_x_m", touch.point.x()},
                 {"point_y_m", touch.point.y()},
                 {"point_z_m", touch.point.z()},
                 {"normal_x", touch.normal.x()},
                 {"normal_y", touch.normal.y()},
                 {"normal_z", touch.normal.z()},
                 {"depth_m", touch.depth_m},
                 {"approach_m_s", report.approach_m_s},
                 {"impulse_Ns", report.impulse_Ns},
                 {"imposed_hold_ms", report.imposed_hold_s * 1e3},
                 {"imposed_no_spin", collision.no_spin},
                 {"eccentricity_deg", collision.eccentricity_deg},
                 {"first_frame", frame == -1 ? std::nullopt : std::optional(frame)},
                 {"list", report.list},
                 {"time_s", collision.time_s},
                 {"contacts", report.contact_count},
                 {"interval", collision.interval},
                 {"gaze_eccentricity_deg", collision.gaze_eccentricity_deg},
                 {"region_eccentricity_deg", collision.region_eccentricity_deg},
                 {"distance_m", collision.distance_m},
                 {"speed_deg_s", collision.speed_deg_s},
                 {"collision_speed_deg_s", collision.collision_speed_deg_s},
                 {"priority", collision.priority},
                 {"imposed_spin_a_x_rad_s", spin_along(spin, &ImposedSpin::a, 0)},
                 {"imposed_spin_a_y_rad_s", spin_along(spin, &ImposedSpin::a, 1)},
                 {"imposed_spin_a_z_rad_s", spin_along(spin, &ImposedSpin::a, 2)},
                 {"imposed_spin_b_x_rad_s", spin_along(spin, &ImposedSpin::b, 0)},
                 {"imposed_spin_b_y_rad_s", spin_along(spin, &ImposedSpin::b, 1)},
                 {"imposed_spin_b_z_rad_s", spin_along(spin, &ImposedSpin::b, 2)}});
  }
}

namespace {

void insert_frames(SQLite::Database& database, std::int64_t id,
                   const std::vector<FrameRecord>& frames) {
  RowInsert rows(database, "frame");
  for (const FrameRecord& frame : frames) {
    rows.insert({{"attempt_id", id},
                 {"frame", frame.frame},
                 {"phase", frame.phase == FramePhase::kFixation ? "fixation" : "stimulus"},
                 {"shown_time_s", frame.shown_time_s},
                 {"scheduled_ns", frame.flip.scheduled_ns},
                 {"submitted_ns", frame.flip.submitted_ns},
                 {"flipped_ns", frame.flip.flipped_ns},
                 {"missed_slots", frame.flip.missed_slots},
                 {"interval", frame.interval},
                 {"patch", frame.patch}});
  }
}

const char* name_of(GazeLoss loss) {
  switch (loss) {
    case GazeLoss::kBlink:
      return "blink";
    case GazeLoss::kOffScreen:
      return "off screen";
    default:
      return "lost";
  }
}

void insert_gaze(SQLite::Database& database, std::int64_t id,
                 const std::vector<GazeSample>& samples) {
  RowInsert rows(database, "gaze");
  std::int64_t number = 0;
  for (const GazeSample& sample : samples) {
    const Fixation& at = sample.at;
    rows.insert({{"attempt_id", id},
                 {"sample", ++number},
                 {"taken_ns", sample.taken_ns},
                 {"x_m", at ? std::optional(at->x_m) : std::nullopt},
                 {"y_m", at ? std::optional(at->y_m) : std::nullopt},
                 {"loss", at ? std::nullopt : std::optional<std::string>(name_of(sample.loss))},
                 {"interval", sample.interval}});
  }
}

void insert_clicks(SQLite::Database& database, std::int64_t id,
                   const std::vector<ClickRecord>& clicks) {
  RowInsert rows(database, "click");
  std::int64_t number = 0;
  for (const ClickRecord& click : clicks) {
    rows.insert({{"attempt_id", id},
                 {"number", ++number},
                 {"device", click.device},
                 {"arrived_ns", click.arrived_ns},
                 {"arrival_uncertainty_ns", click.arrival_uncertainty_ns},
                 {"interval", click.interval}});
  }
}

void insert_markers(SQLite::Database& database, std::int64_t id,
                    const std::vector<MarkerRecord>& markers) {
  RowInsert rows(database, "marker");
  std::int64_t number = 0;
  for (const MarkerRecord& marker : markers) {
    rows.insert({{"attempt_id", id},
                 {"number", ++number},
                 {"event", std::string(name_of(marker.event))},
                 {"code", marker.code},
                 {"event_ns", marker.event_ns},
                 {"written_ns", marker.written_ns},
                 {"interval", marker.interval}});
  }
}

void insert_sounds(SQLite::Database& database, std::int64_t id,
                   const std::vector<SoundRecord>& sounds) {
  RowInsert rows(database, "sound");
  std::int64_t number = 0;
  for (const SoundRecord& sound : sounds) {
    rows.insert({{"attempt_id", id},
                 {"number", ++number},
                 {"step", sound.step},
                 {"lag_ms", sound.lag_ms},
                 {"loudness", sound.loudness},
                 {"shown_ns", sound.shown_ns},
                 {"intended_ns", sound.intended_ns},
                 {"realised_ns", sound.realised_ns},
                 {"interval", sound.interval}});
  }
}

void insert_ratings(SQLite::Database& database, std::int64_t id,
                    const std::vector<RatingRecord>& ratings) {
  RowInsert rows(database, "rating");
  for (const RatingRecord& rating : ratings) {
    rows.insert({{"attempt_id", id},
                 {"rating", rating.rating},
                 {"minimum", rating.minimum},
                 {"maximum", rating.maximum},
                 {"best", rating.best},
                 {"low_anchor", rating.low_anchor},
                 {"high_anchor", rating.high_anchor},
                 {"device", rating.device},
                 {"question_shown_ns", rating.question_shown_ns},
                 {"arrived_ns", rating.arrived_ns},
                 {"arrival_uncertainty_ns", rating.arrival_uncertainty_ns}});
  }
}

void bind_level(SQLite::Statement& statement, int index, const LevelValue& value) {
  if (const auto* text = std::get_if<std::string>(&value)) {
    statement.bind(index, *text);
  } else if (const auto* truth = std::get_if<bool>(&value)) {
    statement.bind(index, *truth ? "true" : "false");
  } else if (const double number = std::get<double>(value);
             std::floor(number) == number && std::abs(number) < 1e15) {
    statement.bind(index, static_cast<std::int64_t>(number));
  } else {
    statement.bind(index, number);
  }
}

/// {"name": value, ...} in this order; whole numbers without a decimal point. As many as a function
/// of SQL takes.
std::string json_object(SQLite::Database& database, const std::vector<FactorLevel>& values) {
  const int most = sqlite3_limit(database.getHandle(), SQLITE_LIMIT_FUNCTION_ARG, -1) / 2;
  if (values.size() > static_cast<std::size_t>(most)) {
    throw SQLite::Exception("a response has at most " + std::to_string(most) + " details",
                            SQLITE_CONSTRAINT);
  }
  std::string sql = "SELECT json_object(";
  for (const FactorLevel& value : values) {
    sql += sql.back() == '(' ? "?, " : ", ?, ";
    sql += std::holds_alternative<bool>(value.value) ? "json(?)" : "?";
  }
  SQLite::Statement query(database, sql + ")");
  int index = 0;
  for (const FactorLevel& value : values) {
    query.bind(++index, value.factor);
    bind_level(query, ++index, value.value);
  }
  query.executeStep();
  return query.getColumn(0).getString();
}

void insert_responses(SQLite::Database& database, std::int64_t id,
                      const std::vector<ResponseRecord>& responses) {
  RowInsert rows(database, "response");
  std::int64_t number = 0;
  for (const ResponseRecord& response : responses) {
    rows.insert({{"attempt_id", id},
                 {"number", ++number},
                 {"kind", response.kind},
                 {"question", response.question},
                 {"answer", text_or_null(response.answer)},
                 {"detail", json_object(database, response.detail)},
                 {"device", response.device},
                 {"question_shown_ns", response.question_shown_ns},
                 {"arrived_ns", response.arrived_ns},
                 {"arrival_uncertainty_ns", response.arrival_uncertainty_ns},
                 {"timed_out", response.timed_out},
                 {"positive", response.positive},
                 {"correct", response.correct}});
  }
}

void insert_not_finite_notes(SQLite::Database& database, std::int64_t session_id,
                             const AttemptRecord& attempt) {
  const std::string trial =
      "trial " + std::to_string(attempt.slot) + ", attempt " + std::to_string(attempt.number);
  for (const StepRecord& step : attempt.steps) {
    for (const NotFiniteBody& found : step.not_finite) {
      insert_row(database, "note",
                 {{"session_id", session_id},
                  {"written_utc", Now()},
                  {"kind", "not finite"},
                  {"text", trial + ", step " + std::to_string(step.step) + ": " +
                               attempt.body_names.at(static_cast<std::size_t>(found.body)) + ", " +
                               std::string(name_of(found.field))}});
    }
  }
}

}  // namespace

std::int64_t late_frames(const AttemptRecord& attempt) {
  return std::count_if(attempt.frames.begin(), attempt.frames.end(),
                       [](const FrameRecord& frame) { return frame.flip.late(); });
}

bool has_not_finite(const AttemptRecord& attempt) {
  return std::any_of(attempt.steps.begin(), attempt.steps.end(),
                     [](const StepRecord& step) { return !step.not_finite.empty(); });
}

void insert_attempt(SQLite::Database& database, const AttemptOwner& owner,
                    const AttemptRecord& attempt, bool keeps_steps) {
  const std::int64_t id = insert_attempt_row(database, owner, attempt);
  if (keeps_steps) {
    insert_steps(database, id, attempt.steps);
  }
  insert_collisions(database, id, attempt);
  insert_frames(database, id, attempt.frames);
  insert_gaze(database, id, attempt.gaze);
  insert_clicks(database, id, attempt.clicks);
  insert_markers(database, id, attempt.markers);
  insert_sounds(database, id, attempt.sounds);
  insert_ratings(database, id, attempt.ratings);
  insert_responses(database, id, attempt.responses);
  insert_not_finite_notes(database, owner.session_id, attempt);
}

}  // namespace impetus::inline store
