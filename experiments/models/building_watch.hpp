// Who hears of the trees that a process builds, wherever it does: a check that needs one knows
// nobody to tell.
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/trees/tree_settings.hpp"

namespace impetus::inline models {

/// While it lives, `heard` is told of each tree that TreeCache builds and whose progress nobody
/// else asked for, its share from 0 to 1. One at a time.
class BuildingWatch {
 public:
  explicit BuildingWatch(Progress heard);
  ~BuildingWatch();
  BuildingWatch(const BuildingWatch&) = delete;
  BuildingWatch& operator=(const BuildingWatch&) = delete;

  /// Empty where there is no watch.
  static const Progress& heard();
};

}  // namespace impetus::inline models
