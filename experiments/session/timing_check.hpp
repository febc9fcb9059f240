// The sync test: do flips follow the display's refresh, and does it run at its nominal rate?
//
// Flips are made as fast as the display lets them. Where flips wait for the refresh, the
// intervals are one refresh long; where they do not, they are far shorter and none is valid.
// (Start-up gate after Psychtoolbox; Kleiner, Brainard and Pelli 2007)
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace impetus::inline session {

/// A note of a session that ended where it would have begun, for its sync test failed.
inline constexpr const char* kSyncTestFailedNote = "sync test failed";

/// What the flips of a display were like, and whether they can be trusted.
struct SyncTest {
  std::int64_t tries{0};
  std::int64_t valid_flips{0};   ///< intervals of 4–40 ms within 20 % of nominal, last try
  double mean_interval_ns{0.0};  ///< of the valid intervals; 0 when there is none
  double sd_interval_ns{0.0};
  bool passed{false};
  std::string verdict;  ///< one sentence, whichever way it went
};

/// Judges the stamps of consecutive unpaced flips. Passes with at least 50 valid intervals whose
/// mean has a standard error below 200 µs and lies within 1 % of nominal.
SyncTest judge_flips(const std::vector<std::int64_t>& flipped_ns, double nominal_hz);

/// Makes `count` unpaced flips and returns their stamps.
using FlipRun = std::function<std::vector<std::int64_t>(int count)>;

/// Up to three tries of 120 flips; the first that passes, or the last.
SyncTest run_sync_test(const FlipRun& flips, double nominal_hz);

}  // namespace impetus::inline session
