// SPDX-License-Identifier: MIT
#include "experiments/timing/content_check.hpp"

#include <algorithm>

namespace impetus::inline timing {

ContentCheck check_content(const std::vector<PatchSighting>& frames) {
  ContentCheck check;
  std::int64_t in_a_row = 0;
  for (const PatchSighting& frame : frames) {
    const bool wrong = frame.seen && *frame.seen != frame.planned;
    check.unreadable += frame.seen ? 0 : 1;
    check.wrong += wrong ? 1 : 0;
    if (wrong && check.first_wrong < 0) {
      check.first_wrong = check.frames;
    }
    in_a_row = wrong ? in_a_row + 1 : 0;
    check.longest_wrong = std::max(check.longest_wrong, in_a_row);
    ++check.frames;
  }
  return check;
}

}  // namespace impetus::inline timing
