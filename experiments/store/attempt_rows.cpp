// SPDX-License-Identifier: MIT
#include "experiments/store/attempt_rows.hpp"

#include <SQLiteCpp/Statement.h>
#include <SQLiteCpp/VariadicBind.h>

#include <algorithm>
#include <optional>

#include "experiments/gaze/gaze_latency.hpp"
#include "experiments/record/wall_names.hpp"
#include "experiments/store/optional_values.hpp"
#include "experiments/store/response_rows.hpp"
#include "experiments/store/step_rows.hpp"

namespace impetus::inline store {
namespace {

void bind_imposed_spin(SQLite::Statement& statement, int first,
                       const std::optional<ImposedSpin>& spin) {
  for (int component = 0; spin && component < 3; ++component) {
    statement.bind(first + component, spin->a[component]);
    statement.bind(first + 3 + component, spin->b[component]);
  }
}

const char* name_of(StopReason reason) {
  switch (reason) {
    case StopReason::kSeparated:
      return "separated";
    case StopReason::kFinest:
      return "finest";
    case StopReason::kGreatestLevel:
      return "greatest level";
    case StopReason::kCapped:
      return "capped";
    default:
      return "budget";
  }
}

std::int64_t insert_attempt_row(SQLite::Database& database, const AttemptOwner& owner,
                                const AttemptRecord& attempt) {
  SQLite::Statement insert(
      database,
      "INSERT INTO attempt (trial_id, session_id, number, outcome, onset_ns, intended_hold_ms, "
      "realised_hold_ms, timed_frames, late_timed_frames, late_untimed_frames, sync_overridden, "
      "gaze_source, gaze_late, interrupted_by, gaze_latency_p95_ms, region_covered_share, "
      "gaze_lost_share, imposed_gaze_latency_ms, saved_utc) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, "
      "?, nullif(?, ''), ?, nullif(?, ''), ?, ?, ?, ?, strftime('%Y-%m-%dT%H:%M:%fZ'))");
  SQLite::bind(insert, owner.trial_id, owner.session_id, attempt.number,
               attempt.outcome == AttemptOutcome::kCompleted ? "completed" : "interrupted",
               attempt.onset_ns, attempt.intended_hold_s * 1e3, attempt.realised_hold_s * 1e3,
               static_cast<std::int64_t>(attempt.frames.size()), late_frames(attempt),
               attempt.late_untimed_frames, owner.sync_overridden ? 1 : 0, attempt.gaze_source,
               attempt.gaze_latency_p95_ms.value_or(0.0) > kMarkedGazeLatency_ms ? 1 : 0,
               attempt.interrupted_by);
  bind_or_null(insert, 15, attempt.gaze_latency_p95_ms);
  bind_or_null(insert, 16, attempt.region_covered_share);
  bind_or_null(insert, 17, attempt.gaze_lost_share);
  if (attempt.imposed_gaze_latency_s) {
    insert.bind(18, *attempt.imposed_gaze_latency_s * 1e3);
  }
  insert.exec();
  return database.getLastInsertRowid();
}

void insert_collisions(SQLite::Database& database, std::int64_t id, const AttemptRecord& attempt) {
  SQLite::Statement insert(
      database,
      "INSERT INTO collision (attempt_id, step, body_a, body_b, level, stopped, point_x_m, "
      "point_y_m, point_z_m, normal_x, normal_y, normal_z, depth_m, approach_m_s, impulse_Ns, "
      "imposed_hold_ms, imposed_no_spin, eccentricity_deg, first_frame, list, time_s, "
      "contacts, interval, gaze_eccentricity_deg, region_eccentricity_deg, distance_m, "
      "speed_deg_s, collision_speed_deg_s, priority, imposed_spin_a_x_rad_s, "
      "imposed_spin_a_y_rad_s, imposed_spin_a_z_rad_s, imposed_spin_b_x_rad_s, "
      "imposed_spin_b_y_rad_s, imposed_spin_b_z_rad_s) "
      "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, nullif(?, -1), ?, ?, ?, ?, "
      "?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
  for (const CollisionRecord& collision : attempt.collisions) {
    const CollisionReport& report = collision.report;
    const TouchPoint& touch = report.contact.touch;
    const auto a = static_cast<std::size_t>(report.bodies.a);
    const std::string body_b = is_wall(report.bodies.b)
                                   ? wall_name(report.bodies.b, attempt.wall_naming)
                                   : attempt.body_names[static_cast<std::size_t>(report.bodies.b)];
    SQLite::bind(insert, id, collision.step, attempt.body_names[a], body_b, report.level,
                 name_of(report.stop), touch.point.x(), touch.point.y(), touch.point.z(),
                 touch.normal.x(), touch.normal.y(), touch.normal.z(), touch.depth_m,
                 report.approach_m_s, report.impulse_Ns, report.imposed_hold_s * 1e3,
                 collision.no_spin ? 1 : 0, collision.eccentricity_deg, collision.first_frame_shown,
                 report.list, collision.time_s, report.contact_count, collision.interval);
    bind_or_null(insert, 24, collision.gaze_eccentricity_deg);
    bind_or_null(insert, 25, collision.region_eccentricity_deg);
    bind_or_null(insert, 26, collision.distance_m);
    bind_or_null(insert, 27, collision.speed_deg_s);
    bind_or_null(insert, 28, collision.collision_speed_deg_s);
    bind_or_null(insert, 29, collision.priority);
    bind_imposed_spin(insert, 30, collision.imposed_spin);
    insert.exec();
    insert.reset();
    insert.clearBindings();
  }
}

void insert_frames(SQLite::Database& database, std::int64_t id,
                   const std::vector<FrameRecord>& frames) {
  SQLite::Statement insert(database,
                           "INSERT INTO frame (attempt_id, frame, phase, shown_time_s, "
                           "scheduled_ns, submitted_ns, flipped_ns, missed_slots, interval, patch) "
                           "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
  for (const FrameRecord& frame : frames) {
    SQLite::bind(insert, id, frame.frame,
                 frame.phase == FramePhase::kFixation ? "fixation" : "stimulus", frame.shown_time_s,
                 frame.flip.scheduled_ns, frame.flip.submitted_ns, frame.flip.flipped_ns,
                 frame.flip.missed_slots, frame.interval);
    if (frame.patch) {
      insert.bind(10, *frame.patch);
    }
    insert.exec();
    insert.reset();
    insert.clearBindings();
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
  SQLite::Statement insert(
      database,
      "INSERT INTO gaze (attempt_id, sample, taken_ns, x_m, y_m, loss, interval) "
      "VALUES (?, ?, ?, ?, ?, ?, ?)");
  std::int64_t number = 0;
  for (const GazeSample& sample : samples) {
    insert.bind(1, id);
    insert.bind(2, ++number);
    insert.bind(3, sample.taken_ns);
    if (sample.at) {
      insert.bind(4, sample.at->x_m);
      insert.bind(5, sample.at->y_m);
    } else {
      insert.bind(6, name_of(sample.loss));
    }
    insert.bind(7, sample.interval);
    insert.exec();
    insert.reset();
    insert.clearBindings();
  }
}

}  // namespace

std::int64_t late_frames(const AttemptRecord& attempt) {
  return std::count_if(attempt.frames.begin(), attempt.frames.end(),
                       [](const FrameRecord& frame) { return frame.flip.late(); });
}

void insert_attempt(SQLite::Database& database, const AttemptOwner& owner,
                    const AttemptRecord& attempt) {
  const std::int64_t id = insert_attempt_row(database, owner, attempt);
  insert_steps(database, id, attempt.steps);
  insert_collisions(database, id, attempt);
  insert_frames(database, id, attempt.frames);
  insert_gaze(database, id, attempt.gaze);
  insert_answers(database, id, attempt);
}

}  // namespace impetus::inline store
