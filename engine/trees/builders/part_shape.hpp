// What the fitting of a volume needs to know of a part of the surface.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "engine/trees/surface_part.hpp"

namespace impetus::inline trees {

struct PartShape {
  /// Corners, each place once; of more than kMostPoints those alone that lie farthest along one of
  /// 386 directions.
  std::vector<Vector3> points;
  Matrix3 axes{Matrix3::Identity()};  ///< columns: principal axes of the area, longest spread first
  Vector3 facing{Vector3::Zero()};    ///< unit, the mean outward normal; zero where sides cancel
  std::vector<Vector3> normals;       ///< unit, of the largest facets, no two nearly parallel
};

inline constexpr std::size_t kMostPoints = 400;

/// Precondition: `part` not empty.
PartShape shape_of(const SurfacePart& part);

/// The same with `points` alone.
std::vector<Vector3> extreme_points(const SurfacePart& part);

/// Unit eigenvectors of a symmetric matrix as the columns of a rotation, of the greatest eigenvalue
/// first: eight sweeps of Jacobi's method, the same on every machine.
Matrix3 eigenvectors_of(Matrix3 symmetric);

}  // namespace impetus::inline trees
