// The gaze of a sitting, as BIDS 1.11 has eye tracking: physio of type "eyetrack".
//
// What stood in for gaze is said in the sidecar: a mouse is no eye.
// SPDX-License-Identifier: MIT
#pragma once

#include <SQLiteCpp/Database.h>

#include "experiments/exports/bids_events.hpp"

namespace impetus::inline exports {

/// `_physio.tsv` before it is compressed: no heading, columns timestamp (seconds from the sitting's
/// zero), x_coordinate, y_coordinate (pixels right of and below the screen's top left corner), then
/// trial, attempt and loss. Throws StoreError.
BidsTable bids_gaze(SQLite::Database& database, const BidsSession& session);

}  // namespace impetus::inline exports
