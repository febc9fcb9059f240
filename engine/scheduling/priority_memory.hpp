// Persistence against popping: which list each pair was in, for as long as it may matter.
//
//   step       1    2    3    4    5         a pair that straddles a threshold, remembered for 2
//   measured   0    1    0    1    1    1
//   given      0    0    0    0    0    1    while it touches
//
// Only what was measured is remembered, so a priority that has fallen for good falls in the end.
// The budget decides how deep a pair is refined all the same. (Dingliana 2002, sec. 5.3.1)
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/scheduling/priority_lists.hpp"

namespace impetus::inline scheduling {

/// Remembers how urgent pairs were that touched, so that they keep it for a while.
class PriorityMemory {
 public:
  /// To be called once in every step. Gives each of `pairs` that touched when the step before ended
  /// the highest list that it was measured in now or in the `steps` steps before. A body and the
  /// enclosure touch when any wall is touched. With 0 steps nothing is remembered.
  void raise(std::vector<MeasuredPair>& pairs, std::int64_t steps);

  /// Which pairs touch at the end of a step; b may be any wall. Where nothing is remembered it need
  /// not be told: what was measured before counts for nothing in the first step that is.
  void note_touching(const std::vector<BodyPair>& touching);

 private:
  static constexpr std::int64_t kNever = -1;

  /// When a pair was last in each list.
  struct Remembered {
    BodyPair pair;
    std::array<std::int64_t, kMostLists> last_in{};  ///< step in which it was measured in each list
  };

  [[nodiscard]] bool touched(const BodyPair& pair) const;
  [[nodiscard]] Remembered remembered(const BodyPair& pair) const;
  void remember_seen(std::int64_t since);

  std::int64_t step_{0};
  std::vector<Remembered> memory_;  ///< sorted by pair
  std::vector<Remembered> seen_;    ///< in this step
  std::vector<Remembered> others_;  ///< not in this step, but lately
  std::vector<BodyPair> touching_;  ///< sorted
};

}  // namespace impetus::inline scheduling
