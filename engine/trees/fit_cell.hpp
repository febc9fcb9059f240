// The cells that fit_error.cpp cuts a volume into, and what bounds the distance of their points
// from a solid. All in the volume's own frame.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <limits>

#include "engine/shapes/triangle_distance.hpp"

namespace impetus::inline trees {

/// What is known of the solid: a triangle of its surface, a box along the volume's axes inside it
/// (given by two opposite corners), or a ball inside it (given by its centre). All are convex, so
/// the distance to one is greatest at a corner of whatever is convex too.
struct Anchor {
  /// Which of the three an anchor is.
  enum class Kind { kBall, kTriangle, kBox };

  Kind kind{Kind::kBall};
  Triangle core;
  double radius_m{0.0};  ///< of a ball

  /// Not below the distance from the point to the solid.
  [[nodiscard]] double distance_m(const Vector3& point) const;
};

Anchor ball_about(const Vector3& centre, double radius_m);

using Range = std::array<double, 2>;

/// The points k + r w with k in a box, r in a range and w a unit vector through a rectangle. Its
/// dimensions, each a range: 0 to 2 of k, kRadius of r, kDirection to the last of w before it is
/// made unit. Those that are one value are not split. Without directions the last three are zero.
struct FitCell {
  static constexpr std::size_t kRadius = 3;
  static constexpr std::size_t kDirection = 4;
  static constexpr int kMostAnchors = 4;

  std::array<Range, 7> ranges;
  double bound_m;
  std::array<Anchor, kMostAnchors> anchors;  ///< the latest first
  int anchor_count;
  int rank;  ///< order of making: breaks ties

  /// Of three dimensions from `first` on, by three bits.
  [[nodiscard]] Vector3 corner(std::size_t first, unsigned which) const;
  [[nodiscard]] Vector3 middle(std::size_t first) const;

  /// Puts it before the others; of too many the oldest goes.
  void remember(const Anchor& anchor);
};

/// All directions within `cosine` of the unit vector `axis`; without directions, axis zero.
struct Cone {
  Vector3 axis{Vector3::Zero()};
  double cosine{1.0};

  /// The direction of the cone that runs farthest along `v`.
  [[nodiscard]] Vector3 farthest_along(const Vector3& v) const;
};

/// The narrowest about the middle of the cell's directions.
Cone cone_of(const FitCell& cell);

/// A point of the volume, and a bound for the distances of a whole cell that comes from there.
struct Farthest {
  Vector3 point{Vector3::Zero()};
  double distance_m{-std::numeric_limits<double>::infinity()};
};

/// A bound for the distance of all points of a cell from the solid, by way of an anchor.
Farthest farthest_from(const Anchor& anchor, const FitCell& cell, const Cone& cone);

}  // namespace impetus::inline trees
