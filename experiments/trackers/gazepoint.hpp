// What the lines of an Open Gaze server say; gazepoint.cpp has the connection.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "experiments/trackers/tracker.hpp"

namespace impetus::inline trackers {

/// A record of the tracker; its time is `remote_ns` of the tracker's clock.
struct GazepointRecord {
  std::int64_t remote_ns{0};
  Reading reading;  ///< without its time
};

/// The record of a line without its end; none: it is another kind of line, or has no time. The best
/// point of gaze (BPOG), or the fixation (FPOG) where that is not sent.
std::optional<GazepointRecord> gazepoint_record(const std::string& line);

/// Takes what came, however it was cut, and leaves in `pending` the line that has not ended.
/// Returns the lines that have.
std::vector<std::string> take_lines(std::string& pending, const std::string& came);

}  // namespace impetus::inline trackers
