// What is recorded of a session as lines of JSON, and back: how a page that has no study file hands
// over what happened, and how one takes it in.
//
//   record ──line_of()──> {"kind": "attempt", ...} ──record_from()──> the same record
//
// Each record's fields are listed once, for both ways. A list of alike things, such as steps, is a
// table: first the names of its columns, then a row for each. Numbers of 64 bits stand as they are:
// who passes lines on must not read them as JavaScript would. Digests of bodies are most of a
// record and follow from its steps, so that they may be left out.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <variant>

#include "experiments/design/plan.hpp"
#include "experiments/record/record.hpp"
#include "experiments/session/timing_check.hpp"

namespace impetus::inline lines {

/// Whether lines of attempts hold the digests of bodies.
enum class Digests { kKept, kLeftOut };

/// What a session in a page says of itself before it begins: the first line of what comes back.
struct SessionRecord {
  std::string participant;
  std::uint64_t seed{0};
  std::string protocol_hash;
  std::string build;    ///< of what runs in the page
  std::string machine;  ///< as the browser calls itself
  std::string display;  ///< size, renderer, clock: what the page could find out
  ScreenGeometry screen;
  bool screen_measured{false};
  double refresh_hz{0.0};
  bool rounding_allowed{false};
  SyncTest sync;
  std::string gaze_source;  ///< "": gaze is not followed
};

/// That this participant has done everything the protocol asks.
struct FinishedRecord {};

/// All that a recorder is given (record/ports.hpp), the session, and the trials that were planned.
using AnyRecord = std::variant<SessionRecord, PlannedTrial, AttemptRecord, QuestionRecord,
                               NoteRecord, ChosenLevel, CalibrationRecord, FinishedRecord>;

/// The record as one line, without a line break.
std::string line_of(const AnyRecord& record, Digests digests = Digests::kLeftOut);

/// The record of a line that was parsed. Throws std::runtime_error, in words ("steps: expected the
/// columns ..., got ..."), for anything but what line_of() makes.
AnyRecord record_from(const nlohmann::json& line);

}  // namespace impetus::inline lines
