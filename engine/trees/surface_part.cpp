// SPDX-License-Identifier: MIT
#include "engine/trees/surface_part.hpp"

#include <cmath>
#include <iterator>
#include <limits>

namespace impetus::inline trees {
namespace {

/// The corners of `facet` where heights, times `sign`, are not negative, and the crossings.
Facet side_of(const Facet& facet, const std::vector<double>& heights, double sign) {
  Facet piece{{}, facet.normal, facet.triangle};
  const std::size_t count = facet.corners.size();
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t next = (i + 1) % count;
    const double here = sign * heights[i];
    const double there = sign * heights[next];
    if (here >= 0.0) {
      piece.corners.push_back(facet.corners[i]);
    }
    if ((here > 0.0 && there < 0.0) || (here < 0.0 && there > 0.0)) {
      // From the same end whichever side asks, so both sides get the same bits.
      const std::size_t low = heights[i] < heights[next] ? i : next;
      const std::size_t high = low == i ? next : i;
      const double share = heights[low] / (heights[low] - heights[high]);
      piece.corners.push_back(facet.corners[low] +
                              share * (facet.corners[high] - facet.corners[low]));
    }
  }
  return piece;
}

/// Where the power distance to `a` is at most that to `b`.
HalfSpace nearer_to(const Sphere& a, const Sphere& b) {
  // |p − a|² − ra² ≤ |p − b|² − rb²  ⇔  (a − b)·p ≥ (|a|² − |b|² + rb² − ra²)/2
  const double offset = 0.5 * (a.centre.squaredNorm() - b.centre.squaredNorm() +
                               b.radius_m * b.radius_m - a.radius_m * a.radius_m);
  return {a.centre - b.centre, offset};
}

}  // namespace

SurfacePart whole_surface(const TriangleMesh& mesh) {
  SurfacePart part;
  part.reserve(mesh.triangles.size());
  for (std::size_t index = 0; index < mesh.triangles.size(); ++index) {
    const auto& [a, b, c] = mesh.triangles[index];
    const std::vector<Vector3> corners{mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]};
    const Vector3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    part.push_back({corners, normal, static_cast<std::uint32_t>(index)});
  }
  return part;
}

std::pair<SurfacePart, SurfacePart> cut(const SurfacePart& part, const HalfSpace& half_space,
                                        double snap) {
  std::pair<SurfacePart, SurfacePart> sides;
  std::vector<double> heights;
  for (const Facet& facet : part) {
    heights.clear();
    bool any_above = false;
    bool any_below = false;
    for (const Vector3& corner : facet.corners) {
      const double height = half_space.height(corner);
      heights.push_back(std::fabs(height) <= snap ? 0.0 : height);
      any_above = any_above || heights.back() > 0.0;
      any_below = any_below || heights.back() < 0.0;
    }
    if (!any_above && !any_below) {
      const bool faces_up = facet.normal.dot(half_space.normal) > 0.0;
      (faces_up ? sides.second : sides.first).push_back(facet);
    } else if (!any_below) {
      sides.first.push_back(facet);
    } else if (!any_above) {
      sides.second.push_back(facet);
    } else {
      sides.first.push_back(side_of(facet, heights, 1.0));
      sides.second.push_back(side_of(facet, heights, -1.0));
    }
  }
  return sides;
}

Vector3 doubled_area_vector(const Facet& facet) {
  Vector3 sum = Vector3::Zero();
  for (std::size_t i = 1; i + 1 < facet.corners.size(); ++i) {
    sum += (facet.corners[i] - facet.corners[0]).cross(facet.corners[i + 1] - facet.corners[0]);
  }
  return sum;
}

double area_m2(const SurfacePart& part) {
  double twice = 0.0;
  for (const Facet& facet : part) {
    twice += doubled_area_vector(facet).norm();
  }
  return 0.5 * twice;
}

std::vector<Vector3> corners_of(const SurfacePart& part) {
  std::vector<Vector3> corners;
  for (const Facet& facet : part) {
    corners.insert(corners.end(), facet.corners.begin(), facet.corners.end());
  }
  return corners;
}

std::vector<SurfacePart> power_cells(SurfacePart part, const std::vector<Sphere>& spheres) {
  std::vector<SurfacePart> cells;
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    SurfacePart left;  // what is nearer to a later sphere
    for (std::size_t j = i + 1; j < spheres.size(); ++j) {
      auto [nearer, farther] = cut(part, nearer_to(spheres[i], spheres[j]));
      left.insert(left.end(), std::make_move_iterator(farther.begin()),
                  std::make_move_iterator(farther.end()));
      part = std::move(nearer);
    }
    cells.push_back(std::move(part));
    part = std::move(left);
  }
  return cells;
}

std::size_t least_power(const std::vector<Sphere>& spheres, const Vector3& point) {
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    const double power =
        (point - spheres[i].centre).squaredNorm() - spheres[i].radius_m * spheres[i].radius_m;
    if (power < least) {
      least = power;
      best = i;
    }
  }
  return best;
}

}  // namespace impetus::inline trees
