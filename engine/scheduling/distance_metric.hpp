// Near collisions first. (Dingliana 2002, sec. 5.2.1)
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/scheduling/priority.hpp"

namespace impetus::inline scheduling {

/// Metres from the eye to the midpoint of the centres.
class DistanceMetric final : public PriorityMetric {
 public:
  DistanceMetric() : PriorityMetric(Urgent::kSmall) {}
  [[nodiscard]] unsigned terms() const override { return 0; }
  [[nodiscard]] double measure(const PairBounds& bounds, const Viewer& viewer,
                               const Fixation& /*fixation*/) const override {
    return (0.5 * (bounds.a.centre + bounds.b.centre) - viewer.eye).norm();
  }
};

}  // namespace impetus::inline scheduling
