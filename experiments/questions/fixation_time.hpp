// How long the cross is shown before a stimulus: always as long, or drawn anew for each.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "experiments/settings/json_document.hpp"
#include "experiments/settings/setting_rows.hpp"

namespace impetus::inline questions {

/// Drawn between the two, in whole frames, where they differ.
struct FixationTime {
  double least_ms{500.0};
  double most_ms{500.0};

  [[nodiscard]] bool is_drawn() const { return least_ms != most_ms; }
};

/// In a protocol: a number, or the least and the most.
Kind<FixationTime> fixation_time_kind();

/// Refuses a least that is more than the most. Throws InputError.
void check_fixation(const JsonDocument& protocol, const FixationTime& time);

/// For how many frames it is shown before this stimulus of the trial of this seed, each number
/// from the least to the most being as likely: the same on any display of this rate.
std::int64_t fixation_frames(const FixationTime& time, std::uint64_t seed, std::int64_t interval,
                             double refresh_hz);

}  // namespace impetus::inline questions
