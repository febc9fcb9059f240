// What happened in a sitting, as tables of BIDS 1.11: events (stimuli, answers, clicks and
// collisions), answers outside trials, and the gaze as physio of type "eyetrack". What stood in for
// gaze is said in the sidecar: a mouse is no eye.
// SPDX-License-Identifier: MIT
#pragma once

#include <SQLiteCpp/Database.h>

#include <cstdint>
#include <string>

#include "experiments/exports/bids_session.hpp"
#include "experiments/exports/export_table.hpp"

namespace impetus::inline exports {

/// A table and the JSON beside it; no rows: there is nothing to write.
struct BidsTable {
  std::string tsv;
  std::string json;
  std::int64_t rows{0};
};

/// `_events.tsv`, by onset (seconds from the sitting's zero). Throws StoreError.
BidsTable bids_events(SQLite::Database& database, const BidsSession& session,
                      const FactorLabels& factors);

/// `_beh.tsv`: what was answered outside trials, which has no onset. Throws StoreError.
BidsTable bids_answers(SQLite::Database& database, const BidsSession& session);

/// `_physio.tsv` before it is compressed: no heading, columns timestamp (seconds from the sitting's
/// zero), x_coordinate, y_coordinate (pixels right of and below the screen's top left corner), then
/// trial, attempt and loss. Throws StoreError.
BidsTable bids_gaze(SQLite::Database& database, const BidsSession& session);

}  // namespace impetus::inline exports
