// An attempt that came as a line, simulated again from its inputs.
//
//   trial ──its stimuli, staged──> steps, each with the work and gaze of its record ──> same
//   hashes?
//
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "experiments/lines/record_lines.hpp"
#include "experiments/protocol/protocol_scenes.hpp"
#include "experiments/run/replay.hpp"

namespace impetus::inline lines {

/// What came of simulating an attempt again.
struct ReplayedAttempt {
  std::int64_t steps{0};  ///< simulated, starts not counted
  std::optional<Divergence> divergence{};
};

/// Stages the sessions of one protocol and screen as they were, and steps them again.
class AttemptReplay {
 public:
  /// `protocol` must outlive this. Of the session, screen, rate and rounding are used. It was
  /// recorded in `recording_format`.
  AttemptReplay(const Protocol& protocol, const SessionRecord& session, int recording_format);

  /// Digests that the attempt was handed over without are filled in as the steps are simulated; so
  /// they are proof of nothing, but a divergence later is named by them.
  ReplayedAttempt replay(const PlannedTrial& trial, AttemptRecord& attempt) const;

 private:
  const Protocol& protocol_;
  ScreenGeometry screen_;
  ProtocolScenes scenes_;
  int recording_format_;
};

/// "trial 5, step 12, body red, position", as `impetus replay` says it.
std::string divergence_words(std::int64_t trial, const Divergence& divergence);

}  // namespace impetus::inline lines
