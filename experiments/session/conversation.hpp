// Pages asked and answered, with the pause and the quitting that may come at any of them.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "experiments/record/ports.hpp"
#include "experiments/session/session_standing.hpp"

namespace impetus::inline session {

/// How a session ended: all done, left by the participant, no consent, or its display closed.
enum class SessionEnding { kFinished, kQuit, kDeclined, kDisplayClosed };

/// Asks the participant page by page, and knows whether and why the session has ended.
class Conversation {
 public:
  /// All must outlive this.
  Conversation(Input& input, Recorder& recorder, const SessionStanding& standing)
      : input_(input), recorder_(recorder), standing_(standing) {}

  /// Asks until there is an answer; nothing when the participant quits or the display closes. A
  /// page that says nothing is not shown.
  std::optional<Answer> ask(const Page& page);

  /// Deals with what interrupted a page or a trial; whether the session goes on.
  bool handle(Interruption interruption);

  /// The session ends so; returns false, for `return end(...)` where going on is true.
  bool end(SessionEnding ending);

  [[nodiscard]] SessionEnding ending() const { return ending_; }

 private:
  bool pause();
  bool display_closed();

  Input& input_;
  Recorder& recorder_;
  const SessionStanding& standing_;
  SessionEnding ending_{SessionEnding::kQuit};
};

}  // namespace impetus::inline session
