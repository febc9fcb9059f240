// Whether regions that follow another participant's recorded gaze have one to follow.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "experiments/protocol/protocol_file.hpp"

namespace impetus::inline protocol {

/// The level of a factor over kRegionKindPointer whose trials follow a recording, and the one whose
/// trials are followed.
inline constexpr const char* kRegionKindPointer = "/engine/region/kind";
inline constexpr const char* kRecordedLevel = "recorded";
inline constexpr const char* kTrackedLevel = "tracked";

/// The condition whose trials are followed under this one; none where the region follows nobody's
/// recording.
[[nodiscard]] std::optional<Condition> followed_condition(const Protocol& protocol,
                                                          const Condition& condition);

/// Recorded regions and /gaze/yoked_to come together, and only as levels of a factor. Throws
/// InputError.
void check_yoking(const Protocol& protocol);

}  // namespace impetus::inline protocol
