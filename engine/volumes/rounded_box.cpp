// SPDX-License-Identifier: MIT
#include "engine/volumes/rounded_box.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace impetus::inline volumes {
namespace {

RoundedBox form_of(const Sphere& sphere) {
  return {sphere.centre, Matrix3::Identity(), Vector3::Zero(), sphere.radius_m};
}

RoundedBox form_of(const RectangleSwept& rectangle) {
  const double u_m = rectangle.half_u.norm();
  const double v_m = rectangle.half_v.norm();
  if (u_m == 0.0 && v_m == 0.0) {
    return form_of(Sphere{rectangle.centre, rectangle.radius_m});
  }
  const Vector3 u =
      u_m > 0.0 ? Vector3(rectangle.half_u / u_m) : unit_across(rectangle.half_v / v_m);
  const Vector3 v = v_m > 0.0 ? Vector3(rectangle.half_v / v_m) : unit_across(u);
  RoundedBox form{rectangle.centre, Matrix3::Identity(), {u_m, v_m, 0.0}, rectangle.radius_m};
  form.axes << u, v, u.cross(v).normalized();
  return form;
}

RoundedBox form_of(const LineSwept& line) {
  return form_of(RectangleSwept{line.centre, line.half_axis, Vector3::Zero(), line.radius_m});
}

RoundedBox form_of(const Box& box) {
  return {box.centre, box.orientation.toRotationMatrix(), box.half_extents_m, 0.0};
}

RoundedBox form_of(const Cube& cube) {
  return form_of(Box{cube.centre, Vector3::Constant(cube.half_edge_m), cube.orientation});
}

/// The shares t where |from + t along| ≤ reach on every axis.
std::optional<SegmentSpan> span_between_slabs(const Vector3& from, const Vector3& along,
                                              const Vector3& reach) {
  SegmentSpan span;
  for (int axis = 0; axis < 3; ++axis) {
    if (along[axis] == 0.0) {
      if (std::fabs(from[axis]) > reach[axis]) {
        return std::nullopt;
      }
      continue;
    }
    const double low = (-reach[axis] - from[axis]) / along[axis];
    const double high = (reach[axis] - from[axis]) / along[axis];
    span.begin = std::max(span.begin, std::min(low, high));
    span.end = std::min(span.end, std::max(low, high));
  }
  return span.begin <= span.end ? std::optional(span) : std::nullopt;
}

/// The shares within `span` where a t² + 2 b t + c ≤ 0, a ≥ 0.
std::optional<SegmentSpan> below_zero(double a, double b, double c, const SegmentSpan& span) {
  if (a == 0.0) {
    return c <= 0.0 ? std::optional(span) : std::nullopt;
  }
  const double discriminant = b * b - a * c;
  if (discriminant < 0.0) {
    return std::nullopt;
  }
  const double far = b > 0.0 ? -(b + std::sqrt(discriminant)) : -b + std::sqrt(discriminant);
  const double one = far / a;
  const double other = far != 0.0 ? c / far : one;
  const SegmentSpan roots{std::max(span.begin, std::min(one, other)),
                          std::min(span.end, std::max(one, other))};
  return roots.begin <= roots.end ? std::optional(roots) : std::nullopt;
}

/// Where the segment from + t along comes within `radius` of the box, t within a span in which no
/// coordinate crosses a face's plane.
std::optional<SegmentSpan> span_near_face(const RoundedBox& volume, const Vector3& from,
                                          const Vector3& along, const SegmentSpan& span) {
  const double middle = 0.5 * (span.begin + span.end);
  double a = 0.0;
  double b = 0.0;
  double c = -volume.radius_m * volume.radius_m;
  for (int axis = 0; axis < 3; ++axis) {
    const double half = volume.half_extents_m[axis];
    const double at = from[axis] + middle * along[axis];
    if (std::fabs(at) > half) {
      const double beyond = from[axis] - std::copysign(half, at);
      a += along[axis] * along[axis];
      b += beyond * along[axis];
      c += beyond * beyond;
    }
  }
  return below_zero(a, b, c, span);
}

}  // namespace

RoundedBox rounded_box(const Volume& volume) {
  return std::visit([](const auto& kind) { return form_of(kind); }, volume);
}

Vector3 upright_reach_m(const RoundedBox& volume) {
  return volume.axes.cwiseAbs() * volume.half_extents_m + Vector3::Constant(volume.radius_m);
}

std::optional<SegmentSpan> span_within(const RoundedBox& volume, const Vector3& from,
                                       const Vector3& to) {
  const Vector3 start = volume.local(from);
  const Vector3 along = volume.local(to) - start;
  const auto slabs = span_between_slabs(start, along, volume.reach_m());
  if (!slabs || volume.radius_m == 0.0) {
    return slabs;
  }
  // The distance to the box is a quadratic between the planes of its faces, and convex over all.
  std::array<double, 8> stops;
  stops.fill(slabs->end);
  stops[0] = slabs->begin;
  std::size_t count = 1;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double half : {-volume.half_extents_m[axis], volume.half_extents_m[axis]}) {
      const double at = along[axis] != 0.0 ? (half - start[axis]) / along[axis] : slabs->begin;
      if (at > slabs->begin && at < slabs->end) {
        stops[count++] = at;
      }
    }
  }
  std::sort(stops.begin(), stops.end());
  std::optional<SegmentSpan> within;
  for (std::size_t i = 0; i < count; ++i) {
    if (const auto piece = span_near_face(volume, start, along, {stops[i], stops[i + 1]})) {
      within = within ? SegmentSpan{within->begin, piece->end} : *piece;
    }
  }
  return within;
}

double least_half_width_m(const Volume& volume) {
  const RoundedBox form = rounded_box(volume);
  return form.half_extents_m.minCoeff() + form.radius_m;
}

}  // namespace impetus::inline volumes
