// SPDX-License-Identifier: MIT
#include "engine/volumes/core_contact.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "engine/numerics/few.hpp"
#include "engine/volumes/core.hpp"
#include "engine/volumes/core_distance.hpp"

namespace impetus::inline volumes {
namespace {

// The middle of what two cores share: of segments the middle of their overlap, of rectangles and
// faces the centroid of the overlap's polygon, of blocks that of the overlap itself.

/// A region with less area than this times its length squared counts as a line; with less volume
/// than this times its length and area, as a surface.
constexpr double kThin = 1e-6;

/// Corners of a convex polygon in order. A rectangle cut by six planes has at most ten.
struct Polygon {
  std::array<Vector3, 16> corners;
  int count{0};

  void add(const Vector3& corner) {
    if (count < static_cast<int>(corners.size())) {  // should rounding make it less than convex
      corners[static_cast<std::size_t>(count++)] = corner;
    }
  }
  [[nodiscard]] const Vector3& operator[](int index) const {
    return corners[static_cast<std::size_t>(index % count)];
  }
};

/// Of two blocks.
using Faces = Few<Polygon, 12>;

/// What of `polygon` has normal · x ≤ bound.
Polygon cut(const Polygon& polygon, const Vector3& normal, double bound) {
  Polygon kept;
  for (int index = 0; index < polygon.count; ++index) {
    const Vector3& from = polygon[index];
    const Vector3& to = polygon[index + 1];
    const double above_from = normal.dot(from) - bound;
    const double above_to = normal.dot(to) - bound;
    if (above_from <= 0.0) {
      kept.add(from);
    }
    if ((above_from < 0.0 && above_to > 0.0) || (above_from > 0.0 && above_to < 0.0)) {
      kept.add(from + above_from / (above_from - above_to) * (to - from));
    }
  }
  return kept;
}

Polygon cut(Polygon polygon, const Core& core, double tolerance_m) {
  for (int axis = 0; axis < 3 && polygon.count > 0; ++axis) {
    const Vector3 normal = core.axes.col(axis);
    const double middle = normal.dot(core.centre);
    const double half_m = core.half_m[axis] + tolerance_m;
    polygon = cut(polygon, normal, middle + half_m);
    if (polygon.count > 0) {
      polygon = cut(polygon, -normal, half_m - middle);
    }
  }
  return polygon;
}

/// The rectangle of the core across `axis`, moved by `side` half extents along it.
Polygon rectangle_across(const Core& core, int axis, double side) {
  const Vector3 middle = core.centre + side * core.half_m[axis] * core.axes.col(axis);
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  const Vector3 half_u = core.half_m[u] * core.axes.col(u);
  const Vector3 half_v = core.half_m[v] * core.axes.col(v);
  Polygon rectangle;
  rectangle.add(middle - half_u - half_v);
  rectangle.add(middle + half_u - half_v);
  rectangle.add(middle + half_u + half_v);
  rectangle.add(middle - half_u + half_v);
  return rectangle;
}

/// What is known of a polygon.
struct Measured {
  Vector3 centroid{Vector3::Zero()};
  double area_m2{0.0};
  Vector3 normal{Vector3::Zero()};  ///< unit; zero for a polygon without area
};

Measured measured(const Polygon& polygon) {
  Vector3 twice_area = Vector3::Zero();
  for (int index = 1; index + 1 < polygon.count; ++index) {
    twice_area += (polygon[index] - polygon[0]).cross(polygon[index + 1] - polygon[0]);
  }
  const double area_m2 = 0.5 * twice_area.norm();
  if (!(area_m2 > 0.0)) {
    return {polygon[0], 0.0};
  }
  const Vector3 normal = twice_area / (2.0 * area_m2);
  Vector3 moment = Vector3::Zero();
  for (int index = 1; index + 1 < polygon.count; ++index) {
    const Vector3 to = polygon[index] - polygon[0];
    const Vector3 next = polygon[index + 1] - polygon[0];
    moment += normal.dot(to.cross(next)) / 6.0 * (to + next);
  }
  return {polygon[0] + moment / area_m2, area_m2, normal};
}

/// From one corner of the polygons to another that is far from it.
struct Span {
  Vector3 middle{Vector3::Zero()};
  double length_m{0.0};
};

Vector3 furthest_corner(const Faces& polygons, const Vector3& from) {
  Vector3 furthest = from;
  for (const Polygon& polygon : polygons) {
    for (int index = 0; index < polygon.count; ++index) {
      if ((polygon[index] - from).squaredNorm() > (furthest - from).squaredNorm()) {
        furthest = polygon[index];
      }
    }
  }
  return furthest;
}

Span span_of(const Faces& polygons) {
  const Vector3 one = furthest_corner(polygons, polygons[0][0]);
  const Vector3 other = furthest_corner(polygons, one);
  return {0.5 * (one + other), (one - other).norm()};
}

/// The part of a segment within the other core; of that, the middle.
std::optional<Vector3> middle_within(const Core& segment, const Core& core, double tolerance_m) {
  const Vector3 half = segment.half_m[0] * segment.axes.col(0);
  double from = -1.0;
  double to = 1.0;
  for (int axis = 0; axis < 3; ++axis) {
    const Vector3 normal = core.axes.col(axis);
    const double start = normal.dot(segment.centre - core.centre);
    const double slope = normal.dot(half);
    const double half_m = core.half_m[axis] + tolerance_m;
    if (slope == 0.0) {
      if (std::abs(start) > half_m) {
        return std::nullopt;
      }
      continue;
    }
    const double one = (-half_m - start) / slope;
    const double other = (half_m - start) / slope;
    from = std::max(from, std::min(one, other));
    to = std::min(to, std::max(one, other));
  }
  return from <= to ? std::optional<Vector3>(segment.centre + 0.5 * (from + to) * half)
                    : std::nullopt;
}

/// Whether the whole polygon lies on a face of the core that looks along `outward`.
bool lies_on_face(const Polygon& polygon, const Vector3& outward, const Core& core,
                  double tolerance_m) {
  for (int axis = 0; axis < 3; ++axis) {
    const double side = core.axes.col(axis).dot(outward) > 0.0 ? 1.0 : -1.0;
    const Vector3 normal = side * core.axes.col(axis);
    const double face = normal.dot(core.centre) + core.half_m[axis] - tolerance_m;
    bool on_face = normal.dot(outward) > 0.5;
    for (int index = 0; on_face && index < polygon.count; ++index) {
      on_face = normal.dot(polygon[index]) >= face;
    }
    if (on_face) {
      return true;
    }
  }
  return false;
}

/// The boundary of what two blocks share: faces of one within the other.
Faces shared_faces(const Core& a, const Core& b, double tolerance_m) {
  Faces faces;
  for (const bool of_a : {true, false}) {
    const Core& own = of_a ? a : b;
    const Core& other = of_a ? b : a;
    for (int axis = 0; axis < 3; ++axis) {
      for (const double side : {1.0, -1.0}) {
        const Polygon face = cut(rectangle_across(own, axis, side), other, tolerance_m);
        const bool counted_already =
            !of_a && lies_on_face(face, side * own.axes.col(axis), other, 2.0 * tolerance_m);
        if (face.count > 0 && !counted_already) {
          faces.add(face);
        }
      }
    }
  }
  return faces;
}

std::optional<Vector3> centroid_of_faces(const Faces& faces) {
  if (faces.empty()) {
    return std::nullopt;
  }
  // Pyramids from the middle of the span, which lies within, onto the faces.
  const Span span = span_of(faces);
  Vector3 surface = Vector3::Zero();
  Vector3 solid = Vector3::Zero();
  double area_m2 = 0.0;
  double volume_m3 = 0.0;
  for (const Polygon& polygon : faces) {
    const Measured face = measured(polygon);
    const Vector3 to_face = face.centroid - span.middle;
    const double pyramid_m3 = face.area_m2 * std::abs(face.normal.dot(to_face)) / 3.0;
    surface += face.area_m2 * to_face;
    solid += 0.75 * pyramid_m3 * to_face;
    area_m2 += face.area_m2;
    volume_m3 += pyramid_m3;
  }
  if (!(area_m2 > kThin * span.length_m * span.length_m)) {
    return span.middle;
  }
  return span.middle + (volume_m3 > kThin * span.length_m * area_m2 ? Vector3(solid / volume_m3)
                                                                    : Vector3(surface / area_m2));
}

/// The centroid of the points that lie in both cores, each grown by `tolerance_m`; none when no
/// such point is found. The region may have any dimension.
std::optional<Vector3> centroid_of_shared(const Core& a, const Core& b, double tolerance_m) {
  const Core& lesser = a.dimension <= b.dimension ? a : b;
  const Core& greater = a.dimension <= b.dimension ? b : a;
  if (lesser.dimension == 0) {
    return lesser.centre;
  }
  if (lesser.dimension == 1) {
    return middle_within(lesser, greater, tolerance_m);
  }
  if (lesser.dimension == 3) {
    return centroid_of_faces(shared_faces(a, b, tolerance_m));
  }
  const Polygon shared = cut(rectangle_across(lesser, 2, 0.0), greater, tolerance_m);
  Faces one;
  if (shared.count > 0) {
    one.add(shared);
  }
  return centroid_of_faces(one);
}

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
