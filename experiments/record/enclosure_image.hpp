// The enclosure as the viewer sees it: the outline of its eight corners on the screen.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "engine/numerics/random_stream.hpp"
#include "engine/scheduling/priority_lists.hpp"
#include "engine/volumes/enclosure.hpp"

namespace impetus::inline record {

class EnclosureImage {
 public:
  /// The whole screen when there is no enclosure, or when the eye is not before all of it.
  EnclosureImage(const std::optional<Enclosure>& enclosure, const Viewer& viewer);

  [[nodiscard]] bool contains(const ScreenPoint& point) const;

  /// A point of the image, all equally likely.
  ScreenPoint uniform_point(RandomStream& stream) const;

  /// The share of the image that lies inside the region, from 0 to 1, found on a grid: right to
  /// about .01. For the record alone.
  [[nodiscard]] double covered_share(const GazeRegion& region) const;

 private:
  [[nodiscard]] ScreenPoint in_frame(double across, double up) const;

  Viewer viewer_;
  std::vector<ScreenPoint> outline_;  ///< convex, anticlockwise
  ScreenPoint least_{};               ///< of the rectangle that frames it
  ScreenPoint greatest_{};
};

}  // namespace impetus::inline record
