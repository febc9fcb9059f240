// Sphere-swept volumes: everything within a radius of a core, a segment or a rectangle (Larsen et
// al. 1999; Dingliana 2002, sec. 4.1.3). A core that is a point is the sphere.
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/volumes/sphere.hpp"

namespace impetus::inline volumes {

/// All points within `radius_m` of the segment centre ± half_axis.
struct LineSwept {
  Vector3 centre{Vector3::Zero()};
  Vector3 half_axis{Vector3::Zero()};
  double radius_m{0.0};
};

/// All points within `radius_m` of the rectangle centre + s half_u + t half_v, |s|, |t| ≤ 1.
/// half_u and half_v are orthogonal; either may be zero.
struct RectangleSwept {
  Vector3 centre{Vector3::Zero()};
  Vector3 half_u{Vector3::Zero()};
  Vector3 half_v{Vector3::Zero()};
  double radius_m{0.0};
};

Sphere bounding_sphere(const LineSwept& line);
CoredVolume cored(const LineSwept& line);
LineSwept placed(const LineSwept& line, const Pose& pose);
bool holds(const LineSwept& line, const Vector3& point);
double content_m3(const LineSwept& line);

Sphere bounding_sphere(const RectangleSwept& rectangle);
CoredVolume cored(const RectangleSwept& rectangle);
RectangleSwept placed(const RectangleSwept& rectangle, const Pose& pose);
bool holds(const RectangleSwept& rectangle, const Vector3& point);
double content_m3(const RectangleSwept& rectangle);

}  // namespace impetus::inline volumes
