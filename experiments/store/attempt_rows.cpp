// SPDX-License-Identifier: MIT
#include "experiments/store/attempt_rows.hpp"

#include <SQLiteCpp/Statement.h>
#include <SQLiteCpp/VariadicBind.h>

#include <algorithm>
#include <bit>

namespace impetus {
namespace {

const std::string kEnclosureName = "enclosure";

const char* name_of(StopReason reason) {
  switch (reason) {
    case StopReason::kSeparated:
      return "separated";
    case StopReason::kFinest:
      return "finest";
    case StopReason::kGreatestLevel:
      return "greatest level";
    default:
      return "budget";
  }
}

/// 16 bits per body and field, little endian on every machine.
std::string pack(const std::vector<BodyDigest>& bodies) {
  std::string bytes;
  for (const BodyDigest& body : bodies) {
    for (const std::uint16_t digest : body) {
      bytes.push_back(static_cast<char>(digest & 0xff));
      bytes.push_back(static_cast<char>(digest >> 8));
    }
  }
  return bytes;
}

std::vector<BodyDigest> unpack(const std::string& bytes) {
  constexpr std::size_t kBytesPerBody = 2 * kStateFieldCount;
  std::vector<BodyDigest> bodies(bytes.size() / kBytesPerBody);
  for (std::size_t i = 0; i < bodies.size() * kStateFieldCount; ++i) {
    const auto low = static_cast<unsigned char>(bytes[2 * i]);
    const auto high = static_cast<unsigned char>(bytes[2 * i + 1]);
    bodies[i / kStateFieldCount][i % kStateFieldCount] =
        static_cast<std::uint16_t>(low | high << 8);
  }
  return bodies;
}

std::int64_t insert_attempt_row(SQLite::Database& database, const AttemptOwner& owner,
                                const AttemptRecord& attempt) {
  const auto late = std::count_if(attempt.frames.begin(), attempt.frames.end(),
                                  [](const FrameRecord& frame) { return frame.flip.late(); });
  SQLite::Statement insert(
      database,
      "INSERT INTO attempt (trial_id, session_id, number, outcome, onset_ns, intended_hold_ms, "
      "realised_hold_ms, timed_frames, late_timed_frames, late_untimed_frames, sync_overridden) "
      "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
  SQLite::bind(insert, owner.trial_id, owner.session_id, attempt.number,
               attempt.outcome == AttemptOutcome::kCompleted ? "completed" : "interrupted",
               attempt.onset_ns, attempt.intended_hold_s * 1e3, attempt.realised_hold_s * 1e3,
               static_cast<std::int64_t>(attempt.frames.size()), static_cast<std::int64_t>(late),
               attempt.late_untimed_frames, owner.sync_overridden ? 1 : 0);
  insert.exec();
  return database.getLastInsertRowid();
}

void insert_steps(SQLite::Database& database, std::int64_t id,
                  const std::vector<StepRecord>& steps) {
  SQLite::Statement insert(database, "INSERT INTO step VALUES (?, ?, ?, ?, ?, ?, ?)");
  for (const StepRecord& step : steps) {
    const std::string digests = pack(step.state.bodies);
    insert.bind(1, id);
    insert.bind(2, step.step);
    insert.bind(3, step.work_granted);
    insert.bind(4, step.work_spent);
    insert.bind(5, static_cast<std::int64_t>(step.degradations));
    insert.bind(6, std::bit_cast<std::int64_t>(step.state.hash));
    insert.bind(7, digests.data(), static_cast<int>(digests.size()));
    insert.exec();
    insert.reset();
  }
}

void insert_collisions(SQLite::Database& database, std::int64_t id, const AttemptRecord& attempt) {
  SQLite::Statement insert(
      database,
      "INSERT INTO collision (attempt_id, step, body_a, body_b, level, stopped, point_x_m, "
      "point_y_m, point_z_m, normal_x, normal_y, normal_z, depth_m, approach_m_s, impulse_Ns, "
      "imposed_hold_ms, imposed_no_spin, eccentricity_deg, first_frame) "
      "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, nullif(?, -1))");
  for (const CollisionRecord& collision : attempt.collisions) {
    const CollisionReport& report = collision.report;
    const TouchPoint& touch = report.contact.touch;
    const auto a = static_cast<std::size_t>(report.bodies.a);
    const std::string& body_b = is_wall(report.bodies.b)
                                    ? kEnclosureName
                                    : attempt.body_names[static_cast<std::size_t>(report.bodies.b)];
    SQLite::bind(insert, id, collision.step, attempt.body_names[a], body_b, report.level,
                 name_of(report.stop), touch.point.x(), touch.point.y(), touch.point.z(),
                 touch.normal.x(), touch.normal.y(), touch.normal.z(), touch.depth_m,
                 report.approach_m_s, report.impulse_Ns, report.imposed_hold_s * 1e3,
                 collision.no_spin ? 1 : 0, collision.eccentricity_deg,
                 collision.first_frame_shown);
    insert.exec();
    insert.reset();
  }
}

void insert_frames(SQLite::Database& database, std::int64_t id,
                   const std::vector<FrameRecord>& frames) {
  SQLite::Statement insert(database, "INSERT INTO frame VALUES (?, ?, ?, ?, ?, ?, ?, ?)");
  for (const FrameRecord& frame : frames) {
    SQLite::bind(insert, id, frame.frame,
                 frame.phase == FramePhase::kFixation ? "fixation" : "stimulus", frame.shown_time_s,
                 frame.flip.scheduled_ns, frame.flip.submitted_ns, frame.flip.flipped_ns,
                 frame.flip.missed_slots);
    insert.exec();
    insert.reset();
  }
}

void insert_ratings(SQLite::Database& database, std::int64_t id,
                    const std::vector<RatingRecord>& ratings) {
  SQLite::Statement insert(database, "INSERT INTO rating VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
  for (const RatingRecord& rating : ratings) {
    SQLite::bind(insert, id, rating.rating, rating.minimum, rating.maximum, rating.best,
                 rating.low_anchor, rating.high_anchor, rating.device, rating.question_shown_ns,
                 rating.arrived_ns, rating.arrival_uncertainty_ns);
    insert.exec();
    insert.reset();
  }
}

}  // namespace

void insert_attempt(SQLite::Database& database, const AttemptOwner& owner,
                    const AttemptRecord& attempt) {
  const std::int64_t id = insert_attempt_row(database, owner, attempt);
  insert_steps(database, id, attempt.steps);
  insert_collisions(database, id, attempt);
  insert_frames(database, id, attempt.frames);
  insert_ratings(database, id, attempt.ratings);
}

std::vector<StepRecord> load_steps(SQLite::Database& database, std::int64_t attempt_id) {
  SQLite::Statement query(database,
                          "SELECT step, work_granted, work_spent, degradations, hash, digests "
                          "FROM step WHERE attempt_id = ? ORDER BY step");
  query.bind(1, attempt_id);
  std::vector<StepRecord> steps;
  while (query.executeStep()) {
    StepRecord step;
    step.step = query.getColumn(0).getInt64();
    step.work_granted = query.getColumn(1).getInt64();
    step.work_spent = query.getColumn(2).getInt64();
    step.degradations = static_cast<std::uint32_t>(query.getColumn(3).getInt64());
    step.state.hash = std::bit_cast<std::uint64_t>(query.getColumn(4).getInt64());
    step.state.bodies = unpack(query.getColumn(5).getString());
    steps.push_back(std::move(step));
  }
  return steps;
}

}  // namespace impetus
