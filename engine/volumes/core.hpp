// What the kinds of volume have in common: a core, and everything within a radius of it.
//
//   core        point     segment      rectangle       block
//   volume      Sphere    LineSwept    RectangleSwept  Box, Cube (radius 0)
//
// (Larsen et al. 1999; Dingliana 2002, sec. 4.1.3)
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/numerics/vector.hpp"

namespace impetus::inline volumes {

/// The points centre + Σ s_i half_m[i] axes.col(i), |s_i| ≤ 1. The axes are orthonormal; the first
/// `dimension` of half_m are positive, the others zero.
struct Core {
  Vector3 centre{Vector3::Zero()};
  Matrix3 axes{Matrix3::Identity()};
  Vector3 half_m{Vector3::Zero()};
  int dimension{0};
};

/// All points within `radius_m` of the core.
struct CoredVolume {
  Core core;
  double radius_m{0.0};
};

Core point_core(const Vector3& centre);

/// Of orthogonal halves; a segment or a point when one of them or both have no length.
Core rectangle_core(const Vector3& centre, const Vector3& half_u, const Vector3& half_v);

/// Of half extents, any of which may be zero, along the columns of `axes`.
Core block_core(const Vector3& centre, const Matrix3& axes, const Vector3& half_m);

/// Whether a comes after b in an order that nothing but their numbers decides: what is worked out
/// in this order is the same both ways round.
bool comes_after(const CoredVolume& a, const CoredVolume& b);

/// Radius about the centre that bounds the core.
double bounding_radius_m(const Core& core);

/// How far the core reaches from its centre along `direction`, times the direction's length.
double reach_along(const Core& core, const Vector3& direction);

/// The middle of the part of the core that reaches furthest along `direction` (unit).
Vector3 furthest_part(const Core& core, const Vector3& direction);

/// The point of the core that is nearest to `point`.
Vector3 nearest_point(const Core& core, const Vector3& point);

/// A unit vector across `direction` (not zero), always the same one.
Vector3 unit_across(const Vector3& direction);

}  // namespace impetus::inline volumes
