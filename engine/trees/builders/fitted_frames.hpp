// Orientations worth trying for a volume round a part.
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/trees/builders/part_shape.hpp"

namespace impetus::inline trees {

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
