// SPDX-License-Identifier: MIT
#include "experiments/session/lateness.hpp"

#include <algorithm>

#include "experiments/tables/number_text.hpp"

namespace impetus::inline session {

void Lateness::take(const AttemptRecord& attempt) {
  for (const FrameRecord& frame : attempt.frames) {
    ++frames_;
    late_ += frame.flip.late() ? 1 : 0;
    missed_ += frame.flip.missed_slots;
  }
}

bool Lateness::exceeds(const LatenessRule& rule) const {
  const double allowed = rule.most_share * static_cast<double>(frames_);
  return rule.then != LatenessRule::Then::kNothing &&
         static_cast<double>(std::max(late_, missed_)) > allowed;
}

double Lateness::slower_share() const {
  return frames_ == 0 ? 0.0 : static_cast<double>(missed_) / static_cast<double>(frames_);
}

std::string Lateness::words() const {
  return printed(
      "%lld of %lld timed frames came late, and what was shown took %.2g %% longer than it "
      "should",
      static_cast<long long>(late_), static_cast<long long>(frames_), 100.0 * slower_share());
}

}  // namespace impetus::inline session
