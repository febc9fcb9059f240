// Where a participant stands in a study: what a page that is opened again goes on from.
//
//   records, as they are kept ──add()──> standing ──to_json()──> kept in the browser   ─┐
//   enrolment in a study file ─────────> standing ──to_json()──> sent by the program   ─┴─> a
//   session
//
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include "experiments/lines/record_lines.hpp"
#include "experiments/protocol/protocol_file.hpp"
#include "experiments/session/session_standing.hpp"

namespace impetus::inline lines {

/// What was done of a plan.
struct Standing {
  Plan plan;  ///< with the adaptive levels that were chosen so far
  SessionHistory history;
};

/// A record that is kept belongs to it from now on. Throws std::runtime_error when it is of no
/// trial of the plan.
void add(const AnyRecord& record, Standing& standing);

/// All but the plan, of which the chosen levels are kept.
nlohmann::json to_json(const Standing& standing, const Design& design);

/// What to_json() made, of this plan. Throws std::runtime_error, in words, for anything else.
Standing standing_from(const nlohmann::json& from, Plan plan, const Design& design);

}  // namespace impetus::inline lines
