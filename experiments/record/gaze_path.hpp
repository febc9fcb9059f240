// The gaze of a recorded trial, step by step: what a yoked region follows.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "engine/scheduling/viewer.hpp"

namespace impetus::inline record {

struct GazePath {
  double viewing_distance_m{0.0};   ///< of the recording's screen
  std::vector<Fixation> fixations;  ///< used in each step, from step 0

  /// The fixation of a step, or of the last one there was.
  [[nodiscard]] Fixation at(std::int64_t step) const {
    if (fixations.empty()) {
      return std::nullopt;
    }
    const auto wanted = static_cast<std::size_t>(step);
    return fixations[wanted < fixations.size() ? wanted : fixations.size() - 1];
  }

  /// The same directions before a screen that is this far away.
  [[nodiscard]] GazePath seen_from(double distance_m) const {
    GazePath path{distance_m, fixations};
    for (Fixation& fixation : path.fixations) {
      if (fixation && distance_m != viewing_distance_m) {
        fixation->x_m *= distance_m / viewing_distance_m;
        fixation->y_m *= distance_m / viewing_distance_m;
      }
    }
    return path;
  }
};

/// By the id of the trial in the study.
using GazePaths = std::map<std::int64_t, GazePath>;

}  // namespace impetus::inline record
