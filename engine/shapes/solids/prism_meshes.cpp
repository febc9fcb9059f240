// SPDX-License-Identifier: MIT
#include "engine/shapes/solids/prism_meshes.hpp"

#include <algorithm>
#include <numeric>
#include <string>

#include "engine/numerics/elementary_functions.hpp"

namespace impetus::inline shapes {
namespace {

using Outline = std::vector<OutlinePoint>;

/// Twice the signed content of the triangle: positive where it runs anticlockwise.
double turn(const OutlinePoint& a, const OutlinePoint& b, const OutlinePoint& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

/// Twice the signed content.
double content(const Outline& outline) {
  double sum = 0.0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    sum += turn({0.0, 0.0}, outline[i], outline[(i + 1) % outline.size()]);
  }
  return sum;
}

bool lies_between(const OutlinePoint& a, const OutlinePoint& b, const OutlinePoint& point) {
  return point.x() >= std::min(a.x(), b.x()) && point.x() <= std::max(a.x(), b.x()) &&
         point.y() >= std::min(a.y(), b.y()) && point.y() <= std::max(a.y(), b.y());
}

/// Whether the segments a–b and c–d share a point.
bool cross(const OutlinePoint& a, const OutlinePoint& b, const OutlinePoint& c,
           const OutlinePoint& d) {
  const double c_side = turn(a, b, c);
  const double d_side = turn(a, b, d);
  const double a_side = turn(c, d, a);
  const double b_side = turn(c, d, b);
  const bool parts_cd = (c_side > 0.0 && d_side < 0.0) || (c_side < 0.0 && d_side > 0.0);
  const bool parts_ab = (a_side > 0.0 && b_side < 0.0) || (a_side < 0.0 && b_side > 0.0);
  return (parts_cd && parts_ab) || (c_side == 0.0 && lies_between(a, b, c)) ||
         (d_side == 0.0 && lies_between(a, b, d)) || (a_side == 0.0 && lies_between(c, d, a)) ||
         (b_side == 0.0 && lies_between(c, d, b));
}

bool holds(const OutlinePoint& a, const OutlinePoint& b, const OutlinePoint& c,
           const OutlinePoint& point) {
  return turn(a, b, point) >= 0.0 && turn(b, c, point) >= 0.0 && turn(c, a, point) >= 0.0;
}

/// Whether the corner at `place` of those that are left can be cut off: it points outwards, and no
/// other corner lies in what would be cut.
bool is_ear(const Outline& outline, const std::vector<std::uint32_t>& left, std::size_t place) {
  const std::uint32_t before = left[(place + left.size() - 1) % left.size()];
  const std::uint32_t after = left[(place + 1) % left.size()];
  const OutlinePoint& a = outline[before];
  const OutlinePoint& b = outline[left[place]];
  const OutlinePoint& c = outline[after];
  return turn(a, b, c) > 0.0 && std::none_of(left.begin(), left.end(), [&](std::uint32_t other) {
           return other != before && other != left[place] && other != after &&
                  holds(a, b, c, outline[other]);
         });
}

/// Cuts off one corner after the other (Meisters 1975). The outline runs anticlockwise.
std::vector<std::array<std::uint32_t, 3>> triangulated(const Outline& outline) {
  std::vector<std::uint32_t> left(outline.size());
  std::iota(left.begin(), left.end(), 0U);
  std::vector<std::array<std::uint32_t, 3>> triangles;
  while (left.size() > 3) {
    std::size_t place = 0;
    while (place + 1 < left.size() && !is_ear(outline, left, place)) {
      ++place;
    }
    triangles.push_back({left[(place + left.size() - 1) % left.size()], left[place],
                         left[(place + 1) % left.size()]});
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(place));
  }
  triangles.push_back({left[0], left[1], left[2]});
  return triangles;
}

}  // namespace

std::string problem_of(const Outline& outline) {
  const std::size_t count = outline.size();
  if (count < 3) {
    return "expected three corners or more, got " + std::to_string(count);
  }
  const auto corner = [&](std::size_t i) -> const OutlinePoint& { return outline[i % count]; };
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = i + 2; j < count; ++j) {
      const bool are_neighbours = i == 0 && j + 1 == count;
      if (!are_neighbours && cross(corner(i), corner(i + 1), corner(j), corner(j + 1))) {
        return "expected sides that do not touch, but those from corner " + std::to_string(i + 1) +
               " and from corner " + std::to_string(j + 1) + " do";
      }
    }
    if (turn(corner(i), corner(i + 1), corner(i + 2)) == 0.0) {
      return "expected corners that turn, but corner " + std::to_string((i + 1) % count + 1) +
             " lies on a line with its neighbours";
    }
  }
  return "";
}

TriangleMesh prism_mesh(Outline outline, double thickness_m) {
  if (content(outline) < 0.0) {
    std::reverse(outline.begin(), outline.end());
  }
  const auto count = static_cast<std::uint32_t>(outline.size());
  TriangleMesh mesh;
  for (const double z : {-0.5 * thickness_m, 0.5 * thickness_m}) {
    for (const OutlinePoint& corner : outline) {
      mesh.vertices.emplace_back(corner.x(), corner.y(), z);
    }
  }
  for (const auto& [a, b, c] : triangulated(outline)) {
    mesh.triangles.push_back({a, c, b});
    mesh.triangles.push_back({a + count, b + count, c + count});
  }
  for (std::uint32_t corner = 0; corner < count; ++corner) {
    const std::uint32_t next = (corner + 1) % count;
    mesh.triangles.push_back({corner, next, next + count});
    mesh.triangles.push_back({corner, next + count, corner + count});
  }
  return mesh;
}

TriangleMesh disc_mesh(double radius_m) {
  constexpr int kCorners = 128;
  constexpr double kThickness = 0.01;  // of the radius
  Outline outline;
  for (int corner = 0; corner < kCorners; ++corner) {
    const SineCosine turned = sine_cosine_deg(360.0 * corner / kCorners);
    outline.emplace_back(radius_m * turned.cosine, radius_m * turned.sine);
  }
  return prism_mesh(std::move(outline), kThickness * radius_m);
}

}  // namespace impetus::inline shapes
