// SPDX-License-Identifier: MIT
#include "experiments/store/step_rows.hpp"

#include <SQLiteCpp/Statement.h>

#include <bit>
#include <string>

namespace impetus::inline store {
namespace {

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

void bind_gaze(SQLite::Statement& insert, int first, const GazeInput& gaze) {
  if (gaze.fixation) {
    insert.bind(first, gaze.fixation->x_m);
    insert.bind(first + 1, gaze.fixation->y_m);
    insert.bind(first + 2, gaze.taken_ns);
    insert.bind(first + 3, gaze.age_ns);
  }
  if (gaze.region) {
    insert.bind(first + 4, gaze.region->centre.x_m);
    insert.bind(first + 5, gaze.region->centre.y_m);
    insert.bind(first + 6, gaze.region->radius_deg);
  }
}

GazeInput gaze_from(SQLite::Statement& query, int first) {
  GazeInput gaze;
  if (!query.getColumn(first).isNull()) {
    gaze.fixation =
        ScreenPoint{query.getColumn(first).getDouble(), query.getColumn(first + 1).getDouble()};
    gaze.taken_ns = query.getColumn(first + 2).getInt64();
    gaze.age_ns = query.getColumn(first + 3).getInt64();
  }
  if (!query.getColumn(first + 4).isNull()) {
    gaze.region =
        GazeRegion{{query.getColumn(first + 4).getDouble(), query.getColumn(first + 5).getDouble()},
                   query.getColumn(first + 6).getDouble()};
  }
  return gaze;
}

}  // namespace

void insert_steps(SQLite::Database& database, std::int64_t id,
                  const std::vector<StepRecord>& steps) {
  SQLite::Statement insert(database,
                           "INSERT INTO step (attempt_id, step, work_granted, work_spent, "
                           "degradations, hash, digests, fixation_x_m, fixation_y_m, "
                           "fixation_taken_ns, fixation_age_ns, region_x_m, region_y_m, "
                           "region_radius_deg, shown_frame, pops, stopped_short, "
                           "largest_pop_deg, interval) "
                           "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, nullif(?, -1), ?, ?, "
                           "?, ?)");
  for (const StepRecord& step : steps) {
    const std::string digests = pack(step.state.bodies);
    insert.bind(1, id);
    insert.bind(2, step.step);
    insert.bind(3, step.work_granted);
    insert.bind(4, step.work_spent);
    insert.bind(5, static_cast<std::int64_t>(step.degradations));
    insert.bind(6, std::bit_cast<std::int64_t>(step.state.hash));
    insert.bind(7, digests.data(), static_cast<int>(digests.size()));
    bind_gaze(insert, 8, step.gaze);
    insert.bind(15, step.shown_frame);
    insert.bind(16, step.pops);
    insert.bind(17, step.stopped_short);
    if (step.pops > 0) {
      insert.bind(18, step.largest_pop_deg);
    }
    insert.bind(19, step.interval);
    insert.exec();
    insert.reset();
    insert.clearBindings();
  }
}

std::vector<StepRecord> load_steps(SQLite::Database& database, std::int64_t attempt_id,
                                   std::int64_t interval) {
  SQLite::Statement query(database,
                          "SELECT step, work_granted, work_spent, degradations, hash, digests, "
                          "fixation_x_m, fixation_y_m, fixation_taken_ns, fixation_age_ns, "
                          "region_x_m, region_y_m, region_radius_deg, coalesce(shown_frame, -1), "
                          "pops, stopped_short, coalesce(largest_pop_deg, 0.0) "
                          "FROM step WHERE attempt_id = ? AND interval = ? ORDER BY step");
  query.bind(1, attempt_id);
  query.bind(2, interval);
  std::vector<StepRecord> steps;
  while (query.executeStep()) {
    StepRecord step;
    step.step = query.getColumn(0).getInt64();
    step.work_granted = query.getColumn(1).getInt64();
    step.work_spent = query.getColumn(2).getInt64();
    step.degradations = static_cast<std::uint32_t>(query.getColumn(3).getInt64());
    step.state.hash = std::bit_cast<std::uint64_t>(query.getColumn(4).getInt64());
    step.state.bodies = unpack(query.getColumn(5).getString());
    step.gaze = gaze_from(query, 6);
    step.shown_frame = query.getColumn(13).getInt64();
    step.pops = query.getColumn(14).getInt64();
    step.stopped_short = query.getColumn(15).getInt64();
    step.largest_pop_deg = query.getColumn(16).getDouble();
    step.interval = interval;
    steps.push_back(std::move(step));
  }
  return steps;
}

}  // namespace impetus::inline store
