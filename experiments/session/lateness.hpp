// How late the timed frames of a session come, counted from one break to the next.
//
//   attempt ─take─> frames, late ones, refreshes missed ─exceeds the rule?─> words for the
//   experimenter
//
// A frame that misses refreshes puts off all that follow it: the stimulus then runs slower than
// real time by as many refreshes as were missed.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include "experiments/questions/script.hpp"
#include "experiments/record/record.hpp"

namespace impetus::inline session {

/// Notes of this kind say that a session's frames came too late.
inline constexpr const char* kLateFramesNote = "late frames";

/// The timed frames of some attempts.
class Lateness {
 public:
  void take(const AttemptRecord& attempt);

  [[nodiscard]] bool exceeds(const LatenessRule& rule) const;
  [[nodiscard]] std::int64_t frames() const { return frames_; }
  [[nodiscard]] std::int64_t late() const { return late_; }
  /// By which share of its length what was shown took longer.
  [[nodiscard]] double slower_share() const;
  /// The same in a sentence, in English.
  [[nodiscard]] std::string words() const;

 private:
  std::int64_t frames_{0};
  std::int64_t late_{0};
  std::int64_t missed_{0};  ///< refreshes that went by without their frame
};

}  // namespace impetus::inline session
