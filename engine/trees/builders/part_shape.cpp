// SPDX-License-Identifier: MIT
#include "engine/trees/builders/part_shape.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "engine/volumes/core.hpp"

namespace impetus::inline trees {
namespace {

constexpr int kJacobiSweeps = 8;
constexpr std::size_t kMostNormals = 3;
constexpr double kNearlyParallel = 0.99;

bool precedes(const Vector3& a, const Vector3& b) {
  return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
}

/// One of each pair of opposite directions to the surface points of a grid of 9³.
std::vector<Vector3> directions() {
  std::vector<Vector3> result;
  for (int x = -4; x <= 4; ++x) {
    for (int y = -4; y <= 4; ++y) {
      for (int z = -4; z <= 4; ++z) {
        const bool on_surface = std::max({std::abs(x), std::abs(y), std::abs(z)}) == 4;
        if (on_surface && std::array{x, y, z} > std::array{0, 0, 0}) {
          result.emplace_back(x, y, z);
        }
      }
    }
  }
  return result;
}

std::vector<Vector3> farthest_of(const std::vector<Vector3>& points) {
  static const std::vector<Vector3> kDirections = directions();
  std::vector<bool> kept(points.size(), false);
  for (const Vector3& direction : kDirections) {
    std::size_t least = 0;
    std::size_t most = 0;
    double least_along = direction.dot(points[0]);
    double most_along = least_along;
    for (std::size_t i = 1; i < points.size(); ++i) {
      const double along = direction.dot(points[i]);
      if (along < least_along) {
        least_along = along;
        least = i;
      } else if (along > most_along) {
        most_along = along;
        most = i;
      }
    }
    kept[least] = true;
    kept[most] = true;
  }
  std::vector<Vector3> extremes;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (kept[i]) {
      extremes.push_back(points[i]);
    }
  }
  return extremes;
}

/// ∫ (p − o)(p − o)ᵀ dA and ∫ (p − o) dA over the facets, times 24 and 6.
struct AreaMoments {
  double area{0.0};  ///< times 2
  Vector3 first{Vector3::Zero()};
  Matrix3 second{Matrix3::Zero()};
};

AreaMoments moments_of(const SurfacePart& part, const Vector3& origin) {
  AreaMoments moments;
  for (const Facet& facet : part) {
    const Vector3 a = facet.corners[0] - origin;
    for (std::size_t i = 1; i + 1 < facet.corners.size(); ++i) {
      const Vector3 b = facet.corners[i] - origin;
      const Vector3 c = facet.corners[i + 1] - origin;
      const double doubled = (b - a).cross(c - a).norm();
      const Vector3 sum = a + b + c;
      moments.area += doubled;
      moments.first += doubled * sum;
      moments.second += doubled * (sum * sum.transpose() + a * a.transpose() + b * b.transpose() +
                                   c * c.transpose());
    }
  }
  return moments;
}

Matrix3 principal_axes(const SurfacePart& part) {
  const AreaMoments moments = moments_of(part, part.front().corners[0]);
  if (!(moments.area > 0.0)) {
    return Matrix3::Identity();
  }
  const Vector3 mean = moments.first / (3.0 * moments.area);
  return eigenvectors_of(moments.second / (12.0 * moments.area) - mean * mean.transpose());
}

std::vector<Vector3> largest_normals(const SurfacePart& part) {
  std::vector<std::pair<double, std::size_t>> by_area;
  std::vector<Vector3> doubled;
  for (const Facet& facet : part) {
    doubled.push_back(doubled_area_vector(facet));
    by_area.emplace_back(-doubled.back().squaredNorm(), by_area.size());
  }
  const std::size_t tried = std::min<std::size_t>(by_area.size(), 32);
  std::partial_sort(by_area.begin(), by_area.begin() + static_cast<std::ptrdiff_t>(tried),
                    by_area.end());
  std::vector<Vector3> normals;
  for (std::size_t i = 0; i < tried && normals.size() < kMostNormals; ++i) {
    const Vector3 normal = doubled[by_area[i].second].normalized();
    const bool known = std::any_of(normals.begin(), normals.end(), [&](const Vector3& other) {
      return std::fabs(other.dot(normal)) > kNearlyParallel;
    });
    if (by_area[i].first < 0.0 && !known) {
      normals.push_back(normal);
    }
  }
  return normals;
}

using Point = std::pair<double, double>;

double turn(const Point& o, const Point& a, const Point& b) {
  return (a.first - o.first) * (b.second - o.second) - (a.second - o.second) * (b.first - o.first);
}

/// Counter-clockwise, without points on its sides. (Andrew 1979)
std::vector<Point> hull_of(std::vector<Point> points) {
  std::sort(points.begin(), points.end());
  std::vector<Point> hull;
  for (int chain = 0; chain < 2; ++chain) {
    const std::size_t start = hull.size();
    for (const Point& point : points) {
      while (hull.size() >= start + 2 && turn(hull[hull.size() - 2], hull.back(), point) <= 0.0) {
        hull.pop_back();
      }
      hull.push_back(point);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

/// The area of the rectangle with sides along and across (x, y), unit.
double area_along(const std::vector<Point>& hull, double x, double y) {
  double least_along = std::numeric_limits<double>::infinity();
  double least_across = least_along;
  double most_along = -least_along;
  double most_across = -least_along;
  for (const auto& [px, py] : hull) {
    const double along = px * x + py * y;
    const double across = py * x - px * y;
    least_along = std::min(least_along, along);
    most_along = std::max(most_along, along);
    least_across = std::min(least_across, across);
    most_across = std::max(most_across, across);
  }
  return (most_along - least_along) * (most_across - least_across);
}

}  // namespace

Matrix3 eigenvectors_of(Matrix3 symmetric) {
  Matrix3 vectors = Matrix3::Identity();
  for (int sweep = 0; sweep < kJacobiSweeps; ++sweep) {
    for (const auto& [p, q] : {std::pair(0, 1), std::pair(0, 2), std::pair(1, 2)}) {
      if (symmetric(p, q) == 0.0) {
        continue;
      }
      // The rotation that clears (p, q), by its tangent t: t² + 2θt − 1 = 0, the smaller root.
      const double theta = (symmetric(q, q) - symmetric(p, p)) / (2.0 * symmetric(p, q));
      const double sign = theta < 0.0 ? -1.0 : 1.0;
      const double tangent = sign / (std::fabs(theta) + std::sqrt(theta * theta + 1.0));
      const double cosine = 1.0 / std::sqrt(tangent * tangent + 1.0);
      Matrix3 turn = Matrix3::Identity();
      turn(p, p) = turn(q, q) = cosine;
      turn(p, q) = tangent * cosine;
      turn(q, p) = -turn(p, q);
      symmetric = (turn.transpose() * symmetric * turn).eval();
      vectors = (vectors * turn).eval();
    }
  }
  std::array<int, 3> order{0, 1, 2};
  std::sort(order.begin(), order.end(), [&](int a, int b) {
    return std::pair(-symmetric(a, a), a) < std::pair(-symmetric(b, b), b);
  });
  Matrix3 sorted;
  sorted.col(0) = vectors.col(order[0]).normalized();
  sorted.col(1) = vectors.col(order[1]).normalized();
  sorted.col(2) = sorted.col(0).cross(sorted.col(1));
  return sorted;
}

std::vector<Vector3> extreme_points(const SurfacePart& part) {
  std::vector<Vector3> points = corners_of(part);
  std::sort(points.begin(), points.end(), precedes);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points.size() > kMostPoints ? farthest_of(points) : points;
}

PartShape shape_of(const SurfacePart& part) {
  PartShape shape;
  shape.points = extreme_points(part);
  shape.axes = principal_axes(part);
  Vector3 doubled_area = Vector3::Zero();
  for (const Facet& facet : part) {
    doubled_area += doubled_area_vector(facet);
  }
  if (doubled_area.norm() > 0.1 * 2.0 * area_m2(part)) {
    shape.facing = doubled_area.normalized();
  }
  shape.normals = largest_normals(part);
  return shape;
}

Matrix3 least_rectangle_frame(const std::vector<Vector3>& points, const Vector3& normal) {
  const Vector3 u = unit_across(normal);
  const Vector3 v = normal.cross(u);
  std::vector<Point> flat;
  flat.reserve(points.size());
  for (const Vector3& point : points) {
    flat.emplace_back(u.dot(point), v.dot(point));
  }
  const std::vector<Point> hull = hull_of(std::move(flat));
  double least = std::numeric_limits<double>::infinity();
  Point along{1.0, 0.0};
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const auto& [ax, ay] = hull[i];
    const auto& [bx, by] = hull[(i + 1) % hull.size()];
    const double length = std::sqrt((bx - ax) * (bx - ax) + (by - ay) * (by - ay));
    if (length > 0.0) {
      const Point direction{(bx - ax) / length, (by - ay) / length};
      const double area = area_along(hull, direction.first, direction.second);
      if (area < least) {
        least = area;
        along = direction;
      }
    }
  }
  Matrix3 frame;
  frame.col(0) = (along.first * u + along.second * v).normalized();
  frame.col(1) = normal.cross(frame.col(0));
  frame.col(2) = normal;
  return frame;
}

std::vector<Matrix3> frames_worth_trying(const PartShape& shape, const Matrix3& parent,
                                         Effort effort) {
  std::vector<Matrix3> frames{parent, shape.axes};
  const auto lay_on = [&](const Vector3& normal) {
    if (normal != Vector3::Zero()) {
      frames.push_back(least_rectangle_frame(shape.points, normal));
    }
  };
  lay_on(shape.facing);
  if (effort == Effort::kQuick) {
    return frames;
  }
  frames.emplace_back(Matrix3::Identity());
  for (const Vector3& normal : shape.normals) {
    lay_on(normal);
  }
  for (int axis = 0; axis < 3; ++axis) {
    lay_on(shape.axes.col(axis));
    lay_on(Vector3::Unit(axis));
  }
  return frames;
}

}  // namespace impetus::inline trees
