// One form for volumes of every kind: all points within a radius of a box that may be flat.
//
//   sphere               a point            ⊕ ball
//   line-swept           a segment          ⊕ ball
//   rectangle-swept      a rectangle        ⊕ ball
//   box, cube            the box itself, radius 0
//
// What is measured or proved of volumes is written once, in this form.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "engine/volumes/volume.hpp"

namespace impetus::inline volumes {

/// The points within `radius_m` of { centre + axes x : |x_i| ≤ half_extents_m[i] }; the columns of
/// `axes` are orthonormal.
struct RoundedBox {
  Vector3 centre{Vector3::Zero()};
  Matrix3 axes{Matrix3::Identity()};
  Vector3 half_extents_m{Vector3::Zero()};
  double radius_m{0.0};

  [[nodiscard]] Vector3 local(const Vector3& point) const {
    return axes.transpose() * (point - centre);
  }
  [[nodiscard]] Vector3 placed(const Vector3& local_point) const {
    return centre + axes * local_point;
  }
  /// Half the sides of the smallest box along the axes that holds it.
  [[nodiscard]] Vector3 reach_m() const { return half_extents_m + Vector3::Constant(radius_m); }
};

/// The volume in this form, up to rounding.
RoundedBox rounded_box(const Volume& volume);

/// The half sides of the smallest box along the coordinates' axes, about the same centre, that
/// holds it.
Vector3 upright_reach_m(const RoundedBox& volume);

/// Half the least distance of two parallel planes that hold the volume between them.
double least_half_width_m(const Volume& volume);

/// Shares of a segment from its first end, 0 ≤ begin ≤ end ≤ 1.
struct SegmentSpan {
  double begin{0.0};
  double end{1.0};
};

/// The part of the segment from–to that lies in the volume, to rounding; empty where they do not
/// meet.
std::optional<SegmentSpan> span_within(const RoundedBox& volume, const Vector3& from,
                                       const Vector3& to);

}  // namespace impetus::inline volumes
