// SPDX-License-Identifier: MIT
#include "engine/trees/surface_part.hpp"

#include <cmath>

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

}  // namespace impetus::inline trees
