// SPDX-License-Identifier: MIT
#include "engine/trees/builders/part_halving.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace impetus::inline trees {
namespace {

constexpr std::size_t kMostFacets = 600;
constexpr std::array<double, 5> kPlaces{0.5, 0.375, 0.625, 0.25, 0.75};
constexpr std::size_t kFacetPlanes = 2;    ///< along each axis
constexpr double kSameOffsetShare = 1e-7;  ///< of the size
constexpr double kAcross = 1.0 - 1e-9;     ///< cosine
constexpr double kInteriorShare = 1e-3;    ///< of the extent, at both ends
/// A half's extent counts as this much reach: it is what the next cuts have to overcome.
constexpr double kHalfExtentShare = 0.3;

/// Every so manieth facet.
SurfacePart sketch_of(const SurfacePart& part) {
  const std::size_t stride = (part.size() + kMostFacets - 1) / kMostFacets;
  SurfacePart sketch;
  for (std::size_t i = 0; i < part.size(); i += stride) {
    sketch.push_back(part[i]);
  }
  return sketch;
}

/// Where the largest of the facets across `axis` lie along it, the largest area first.
std::vector<double> facet_offsets(const SurfacePart& part, const Vector3& axis, double size_m) {
  std::vector<std::pair<double, double>> by_offset;  // offset, doubled area
  for (const Facet& facet : part) {
    const Vector3 doubled = doubled_area_vector(facet);
    if (std::fabs(doubled.dot(axis)) > kAcross * doubled.norm()) {
      by_offset.emplace_back(axis.dot(facet.corners[0]), doubled.norm());
    }
  }
  std::sort(by_offset.begin(), by_offset.end());
  std::vector<std::pair<double, double>> by_area;  // −doubled area, offset
  for (const auto& [offset, area] : by_offset) {
    if (by_area.empty() || offset - by_area.back().second > kSameOffsetShare * size_m) {
      by_area.emplace_back(0.0, offset);
    }
    by_area.back().first -= area;
  }
  std::sort(by_area.begin(), by_area.end());
  std::vector<double> offsets;
  offsets.reserve(by_area.size());
  for (const auto& [area, offset] : by_area) {
    offsets.push_back(offset);
  }
  return offsets;
}

std::vector<HalfSpace> planes_across(const Vector3& axis, const SurfacePart& part,
                                     const PartShape& shape, double size_m, bool at_places) {
  double least = axis.dot(shape.points.front());
  double most = least;
  for (const Vector3& point : shape.points) {
    least = std::min(least, axis.dot(point));
    most = std::max(most, axis.dot(point));
  }
  const double extent = most - least;
  std::vector<HalfSpace> planes;
  std::size_t of_facets = 0;
  for (const double offset : facet_offsets(part, axis, size_m)) {
    const bool interior =
        offset > least + kInteriorShare * extent && offset < most - kInteriorShare * extent;
    if (interior && of_facets < kFacetPlanes) {
      planes.push_back({axis, offset});
      ++of_facets;
    }
  }
  for (const double place : kPlaces) {
    if (at_places) {
      planes.push_back({axis, least + place * extent});
    }
  }
  return planes;
}

std::vector<HalfSpace> planes_worth_trying(const SurfacePart& part, const PartShape& shape,
                                           const Matrix3& frame, double size_m) {
  std::vector<HalfSpace> planes;
  const auto add = [&](const Vector3& axis, bool at_places) {
    for (const HalfSpace& plane : planes_across(axis, part, shape, size_m, at_places)) {
      planes.push_back(plane);
    }
  };
  for (int axis = 0; axis < 3; ++axis) {
    add(frame.col(axis), true);
  }
  for (const Vector3& normal : shape.normals) {
    add(normal, false);
  }
  return planes;
}

double cost_of(const SurfacePart& half, const QuickFit& fit) {
  const PartShape shape = shape_of(half);
  const double reach_m =
      fit(shape).reach_m + kHalfExtentShare * bounds_of(shape.points).sides().maxCoeff();
  return reach_m * reach_m * area_m2(half);
}

}  // namespace

std::optional<HalfSpace> best_halving(const SurfacePart& part, const PartShape& shape,
                                      const Matrix3& frame, double size_m, const QuickFit& fit) {
  const SurfacePart sketch = sketch_of(part);
  std::optional<HalfSpace> best;
  double least = 0.0;
  for (const HalfSpace& plane : planes_worth_trying(part, shape, frame, size_m)) {
    const auto [above, below] = cut(sketch, plane, kSnapShare * size_m);
    if (above.empty() || below.empty()) {
      continue;
    }
    double cost = cost_of(above, fit);
    if (!best || cost < least) {
      cost += cost_of(below, fit);
      if (!best || cost < least) {
        least = cost;
        best = plane;
      }
    }
  }
  return best;
}

}  // namespace impetus::inline trees
