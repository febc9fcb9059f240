// SPDX-License-Identifier: MIT
#include "engine/volumes/core_contact.hpp"

#include <cmath>

#include "engine/volumes/closest_points.hpp"
#include "engine/volumes/separating_axes.hpp"
#include "engine/volumes/shared_region.hpp"

namespace impetus::inline volumes {
namespace {

/// Cosine below which a direction does not tell one sense of an axis from the other.
constexpr double kAcross = 1e-9;
/// Times what rounding can do to a distance: what cores are grown by to find what they share.
constexpr double kSharing = 1000.0;

/// Cores that lie on one line, which may be a point: any direction across it parts them as well as
/// any other, so it is the fallback's part across it.
Vector3 across_the_line(const Vector3& line, const Vector3& fallback) {
  const Vector3 across = fallback - fallback.dot(line) * line;
  const double length = across.norm();
  return length > kAcross ? Vector3(across / length) : unit_across(line);
}

bool are_on_one_line(const Core& a, const Core& b) {
  return a.dimension <= 1 && b.dimension <= 1 &&
         (a.dimension == 0 || b.dimension == 0 ||
          a.axes.col(0).cross(b.axes.col(0)).norm() <= kAcross);
}

Penetration way_out(const Core& a, const Core& b, const Vector3& fallback) {
  if (!are_on_one_line(a, b)) {
    return least_penetration(a, b);
  }
  if (a.dimension == 0 && b.dimension == 0) {
    return {fallback, 0.0};
  }
  const Vector3 axis = across_the_line((a.dimension == 1 ? a : b).axes.col(0), fallback);
  return {axis, -gap_along(a, b, axis)};
}

/// The sense of an axis that points from b to a. Precondition: a comes first in order.
Penetration with_sense(Penetration out, const Core& a, const Core& b, const Vector3& fallback) {
  const Vector3 b_to_a = a.centre - b.centre;
  const double along_centres = out.axis.dot(b_to_a);
  const double along_fallback = out.axis.dot(fallback);
  if (std::abs(along_centres) > kAcross * b_to_a.norm() + rounding_slack_m(a, b)) {
    out.axis *= along_centres < 0.0 ? -1.0 : 1.0;
  } else if (std::abs(along_fallback) > kAcross) {
    out.axis *= along_fallback < 0.0 ? -1.0 : 1.0;
  }
  return out;
}

/// Volumes that are the same in all but name have nothing but the fallback to tell them apart.
bool are_twins(const CoredVolume& a, const CoredVolume& b) {
  return !comes_after(a, b) && !comes_after(b, a);
}

TouchPoint contact_of_meeting(const CoredVolume& a, const CoredVolume& b, const Vector3& fallback) {
  const Core& core_a = a.core;
  const Core& core_b = b.core;
  Penetration out = with_sense(way_out(core_a, core_b, fallback), core_a, core_b, fallback);
  if (are_twins(a, b) && std::abs(out.axis.dot(fallback)) <= kAcross) {
    out = {fallback, -gap_along(core_a, core_b, fallback)};
  }
  const double tolerance_m = kSharing * rounding_slack_m(core_a, core_b);
  TouchPoint contact;
  contact.normal = out.axis;
  contact.depth_m = a.radius_m + b.radius_m + out.depth_m;
  contact.point = centroid_of_shared(core_a, core_b, tolerance_m)
                      .value_or(nearest_point(core_a, core_b.centre));
  return contact;
}

TouchPoint contact_of_apart(const CoredVolume& a, const CoredVolume& b,
                            const ClosestOfCores& closest) {
  const Vector3 b_to_a = closest.on_a - closest.on_b;
  const double distance_m = std::sqrt(closest.squared_m2);
  const double reach_m = a.radius_m + b.radius_m;
  Core b_moved = b.core;
  b_moved.centre += b_to_a;
  const double tolerance_m = kSharing * rounding_slack_m(a.core, b.core);
  const Vector3 on_a = centroid_of_shared(a.core, b_moved, tolerance_m).value_or(closest.on_a);
  const Vector3 on_b = on_a - b_to_a;
  TouchPoint contact;
  contact.normal = b_to_a / distance_m;
  contact.depth_m = reach_m - distance_m;
  contact.point = reach_m > 0.0 ? Vector3((b.radius_m * on_a + a.radius_m * on_b) / reach_m)
                                : Vector3(0.5 * (on_a + on_b));
  return contact;
}

/// Worked out about a's centre, so that it is as exact far from the origin as near it.
TouchPoint contact_in_order(CoredVolume a, CoredVolume b, const Vector3& fallback) {
  const Vector3 origin = a.core.centre;
  b.core.centre -= origin;
  a.core.centre.setZero();
  const std::optional<ClosestOfCores> closest = closest_points(a.core, b.core);
  TouchPoint contact =
      closest ? contact_of_apart(a, b, *closest) : contact_of_meeting(a, b, fallback);
  contact.point += origin;
  return contact;
}

}  // namespace

TouchPoint core_contact(const CoredVolume& a, const CoredVolume& b, const Vector3& fallback) {
  if (!comes_after(a, b)) {
    return contact_in_order(a, b, fallback);
  }
  TouchPoint contact = contact_in_order(b, a, -fallback);
  contact.normal = -contact.normal;
  return contact;
}

}  // namespace impetus::inline volumes
