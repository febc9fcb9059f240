// The part of a session before its main trials: demonstrations, then practice until it suffices.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "experiments/session/trial_sequence.hpp"

namespace impetus::inline session {

class PracticePart {
 public:
  /// Both must outlive this.
  PracticePart(const Sitting& sitting, TrialSequence& trials)
      : sitting_(sitting), trials_(trials) {}

  /// Demonstrations, then practice; nothing once main trials have begun. Whether the session goes
  /// on; when it does not, the sitting's conversation knows why.
  bool run();

 private:
  bool train();
  bool practise_rounds();
  bool demonstrate();
  [[nodiscard]] std::vector<std::string> missing_in(std::int64_t round) const;
  bool ask_whether_to_go_on();

  const Sitting& sitting_;
  TrialSequence& trials_;
};

}  // namespace impetus::inline session
