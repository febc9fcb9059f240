// What Pupil's messages say of a surface; pupil.cpp has the connection.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "experiments/trackers/tracker.hpp"

namespace impetus::inline trackers {

/// Gaze below this confidence is lost; Pupil's own threshold.
inline constexpr double kLeastConfidence = 0.6;

/// The gaze on the surface of this name that a message (MessagePack) holds, in order of time. None
/// of another surface; what cannot be read, or has no time, is passed over.
std::vector<Reading> surface_readings(const std::string& message, const std::string& surface,
                                      const ClockEstimate& clock);

}  // namespace impetus::inline trackers
