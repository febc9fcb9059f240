// The volume of each kind that reaches least beyond an object, round a part of its surface.
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/trees/builders/part_shape.hpp"
#include "engine/trees/builders/reach_beyond.hpp"
#include "engine/volumes/volume.hpp"

namespace impetus::inline trees {

/// A volume that holds the points of the part's shape but for rounding.
struct Fit {
  Volume volume;
  double reach_m{0.0};                 ///< of reach_beyond_m()
  Matrix3 frame{Matrix3::Identity()};  ///< columns: the axes of the volume, or the part's
};

/// What a fit is made from; `frames` are those to start at.
struct FitTask {
  const PartShape* shape;
  DistanceToUse solid;
  std::vector<Matrix3> frames;
  Effort effort;
};

Fit fit_sphere(const FitTask& task);
Fit fit_line(const FitTask& task);
Fit fit_rectangle(const FitTask& task);
Fit fit_box(const FitTask& task);

/// The same core or orientation, with the radius or the extents that hold `corners`, and as much
/// more as rounding asks for: `margin_m` or a power of two of it. holds() is true of every corner.
Volume grown_to_hold(const Volume& volume, const std::vector<Vector3>& corners, double margin_m);

}  // namespace impetus::inline trees
