// What the fitting of a volume needs to know of a part of the surface, and the orientations worth
// trying for a volume round it.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "engine/trees/surface_part.hpp"

namespace impetus::inline trees {

/// The points, directions and normals of a part.
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

/// How much is tried: quick to compare ways of splitting, careful for what becomes a node.
enum class Effort { kQuick, kCareful };

/// The parent's frame, the world's, the principal axes, and for the mean and the largest facets'
/// normals (careful: for all three principal axes, too) the frame whose third axis it is and whose
/// others span the smallest rectangle round the points. Columns are the axes of a rotation.
std::vector<Matrix3> frames_worth_trying(const PartShape& shape, const Matrix3& parent,
                                         Effort effort);

/// The rotation with `normal` (unit) as its third column whose first two span the rectangle of the
/// smallest area round the points: one side lies along an edge of their hull. (Freeman and Shapira
/// 1975)
Matrix3 least_rectangle_frame(const std::vector<Vector3>& points, const Vector3& normal);

}  // namespace impetus::inline trees
