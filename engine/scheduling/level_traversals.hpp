// Orders of work that ask nothing of the gaps between surfaces. (Dingliana 2002, fig. 5.1)
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/scheduling/traversals.hpp"

namespace impetus::inline scheduling {

/// The first pair that is unfinished: one after the other, by falling priority.
class DepthFirst final : public Traversal {
 public:
  [[nodiscard]] unsigned terms() const override { return 0; }
  [[nodiscard]] double urgency(const PairProgress& /*pair*/) const override { return 0.0; }
};

/// The pair at the coarsest level: level after level.
class BreadthFirst final : public Traversal {
 public:
  [[nodiscard]] unsigned terms() const override { return kProgressTerm; }
  [[nodiscard]] double urgency(const PairProgress& pair) const override {
    return -static_cast<double>(pair.level());
  }
};

}  // namespace impetus::inline scheduling
