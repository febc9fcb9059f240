// SPDX-License-Identifier: MIT
#include "experiments/store/step_rows.hpp"

#include <algorithm>
#include <bit>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>

#include "experiments/store/rows.hpp"

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

/// "entry 1200 model 300"; nothing where nothing was refused.
std::optional<std::string> text_of(const WorkGrants& cut) {
  std::string text;
  for (std::size_t phase = 0; phase < kWorkPhases; ++phase) {
    if (cut.units[phase] != kUnlimitedTests) {
      text += (text.empty() ? "" : " ") + std::string(kWorkPhaseNames[phase]) + " " +
              std::to_string(cut.units[phase]);
    }
  }
  return text.empty() ? std::nullopt : std::optional(text);
}

/// Throws std::invalid_argument, with one sentence, where somebody changed the text by hand.
WorkGrants grants_from(const std::string& text) {
  WorkGrants cut;
  std::istringstream words(text);
  std::string phase;
  while (words >> phase) {
    const auto* const name = std::find(kWorkPhaseNames.begin(), kWorkPhaseNames.end(), phase);
    if (name == kWorkPhaseNames.end() ||
        !(words >> cut.units[static_cast<std::size_t>(name - kWorkPhaseNames.begin())])) {
      throw std::invalid_argument(
          "step.cut_work: expected phases and units, as entry 1200, got \"" + text + "\"");
    }
  }
  return cut;
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
  RowInsert rows(database, "step");
  for (const StepRecord& step : steps) {
    const std::optional<GazeRegion>& region = step.gaze.region;
    const auto if_fixated = [&](auto value) {
      return step.gaze.fixation ? std::optional(value) : std::nullopt;
    };
    const ScreenPoint fixation = step.gaze.fixation.value_or(ScreenPoint{});
    rows.insert(
        {{"attempt_id", id},
         {"step", step.step},
         {"work_granted", step.work_granted},
         {"work_spent", step.work_spent},
         {"degradations", step.degradations},
         {"hash", step.state.hash},
         {"digests", Bytes{pack(step.state.bodies)}},
         {"fixation_x_m", if_fixated(fixation.x_m)},
         {"fixation_y_m", if_fixated(fixation.y_m)},
         {"fixation_taken_ns", if_fixated(step.gaze.taken_ns)},
         {"fixation_age_ns", if_fixated(step.gaze.age_ns)},
         {"region_x_m", region ? std::optional(region->centre.x_m) : std::nullopt},
         {"region_y_m", region ? std::optional(region->centre.y_m) : std::nullopt},
         {"region_radius_deg", region ? std::optional(region->radius_deg) : std::nullopt},
         {"shown_frame", step.shown_frame == -1 ? std::nullopt : std::optional(step.shown_frame)},
         {"pops", step.pops},
         {"stopped_short", step.stopped_short},
         {"largest_pop_deg", step.pops > 0 ? std::optional(step.largest_pop_deg) : std::nullopt},
         {"interval", step.interval},
         {"cut_work", text_of(step.cut_work)}});
  }
}

std::vector<StepRecord> load_steps(SQLite::Database& database, std::int64_t attempt_id,
                                   std::int64_t interval) {
  SQLite::Statement query(database,
                          "SELECT step, work_granted, work_spent, degradations, hash, digests, "
                          "fixation_x_m, fixation_y_m, fixation_taken_ns, fixation_age_ns, "
                          "region_x_m, region_y_m, region_radius_deg, coalesce(shown_frame, -1), "
                          "pops, stopped_short, coalesce(largest_pop_deg, 0.0), cut_work "
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
    if (!query.getColumn(17).isNull()) {
      step.cut_work = grants_from(query.getColumn(17).getString());
    }
    steps.push_back(std::move(step));
  }
  return steps;
}

}  // namespace impetus::inline store
