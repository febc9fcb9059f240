// What the parts of a session share: who sits there, what is asked, how far it is.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "experiments/design/design.hpp"
#include "experiments/record/script.hpp"
#include "experiments/session/conversation.hpp"
#include "experiments/session/gaze_calibration.hpp"
#include "experiments/session/session_standing.hpp"
#include "experiments/session/trial.hpp"

namespace impetus::inline session {

/// All must outlive the parts.
struct Sitting {
  const Script& script;
  const Design& design;
  Ports& ports;  ///< with the present correction of the gaze
  SessionStanding& standing;
  Conversation& talk;
  std::optional<GazeCalibration>& calibration;  ///< none: the gaze is not calibrated

  /// Asks until there is an answer; nothing when the session ends.
  [[nodiscard]] std::optional<Answer> ask(const Page& page) const { return talk.ask(page); }
  [[nodiscard]] SessionProgress progress() const { return standing.progress(); }
};

}  // namespace impetus::inline session
