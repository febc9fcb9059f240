// SPDX-License-Identifier: MIT
#include "engine/trees/builders/fitted_frames.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace impetus::inline trees {
namespace {

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

Vector3 across(const Vector3& normal) {
  int smallest = 0;
  normal.cwiseAbs().minCoeff(&smallest);
  return normal.cross(Vector3::Unit(smallest)).normalized();
}

}  // namespace

Matrix3 least_rectangle_frame(const std::vector<Vector3>& points, const Vector3& normal) {
  const Vector3 u = across(normal);
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
