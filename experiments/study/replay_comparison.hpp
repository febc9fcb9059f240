// Recorded attempts simulated again, and every value compared that follows from their inputs.
//
//   attempt ──staged──> steps, each with its recorded gaze and work ──> states, work, collisions
//                                                                        │ as a live run keeps them
//                                        rows of the study <──compared──> rows of a table beside
//
// SPDX-License-Identifier: MIT
#pragma once

#include <SQLiteCpp/Database.h>

#include <cstdint>
#include <string>
#include <vector>

#include "experiments/study/replay_library.hpp"

namespace impetus::inline study {

/// Compares the attempts of a study one after another.
class ReplayComparison {
 public:
  /// `study` and `library`, which is of it, must outlive this.
  ReplayComparison(StudyFile& study, ReplayLibrary& library);

  /// The first value of the attempt that is not as its inputs lead to, or what is missing of it:
  /// "diverges at step 12 of interval 2, body red, position"; "" when everything is there and as it
  /// was. What follows in the same attempt would follow from it. Throws InputError where the
  /// attempt cannot be simulated, SQLite::Exception where the study cannot be read.
  std::string problem_of(const StoredAttempt& attempt);

  /// "body red is taken out at step 12: its position is not finite", of the last attempt.
  [[nodiscard]] const std::vector<std::string>& taken_out() const { return taken_out_; }

  /// Of all attempts so far; what was simulated is in the stimuli's own time.
  [[nodiscard]] std::int64_t steps() const { return steps_; }
  [[nodiscard]] double simulated_s() const { return simulated_s_; }

 private:
  std::string simulate(const StoredAttempt& attempt, std::int64_t interval, AttemptRecord& again);

  StudyFile& study_;
  ReplayLibrary& library_;
  SQLite::Database again_;  ///< what the last attempt came to, in tables like the study's
  std::vector<std::string> taken_out_;
  std::int64_t steps_{0};
  double simulated_s_{0.0};
};

}  // namespace impetus::inline study
