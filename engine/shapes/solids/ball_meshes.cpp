// SPDX-License-Identifier: MIT
#include "engine/shapes/solids/ball_meshes.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace impetus::inline shapes {
namespace {

/// The twelve vertices are the corners of three golden rectangles.
TriangleMesh icosahedron() {
  const double golden = 0.5 * (1.0 + std::sqrt(5.0));
  TriangleMesh mesh;
  mesh.vertices = {{-1.0, golden, 0.0},  {1.0, golden, 0.0},   {-1.0, -golden, 0.0},
                   {1.0, -golden, 0.0},  {0.0, -1.0, golden},  {0.0, 1.0, golden},
                   {0.0, -1.0, -golden}, {0.0, 1.0, -golden},  {golden, 0.0, -1.0},
                   {golden, 0.0, 1.0},   {-golden, 0.0, -1.0}, {-golden, 0.0, 1.0}};
  mesh.triangles = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                    {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                    {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                    {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  return mesh;
}

/// Splits triangles in four; two that share an edge share its midpoint.
class Splitter {
 public:
  explicit Splitter(TriangleMesh& mesh) : mesh_(&mesh) {}

  void split_all() {
    std::vector<std::array<std::uint32_t, 3>> finer;
    for (const auto& [a, b, c] : mesh_->triangles) {
      const std::uint32_t ab = midpoint(a, b);
      const std::uint32_t bc = midpoint(b, c);
      const std::uint32_t ca = midpoint(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
    }
    mesh_->triangles.swap(finer);
  }

 private:
  std::uint32_t midpoint(std::uint32_t from, std::uint32_t to) {
    const auto fresh = static_cast<std::uint32_t>(mesh_->vertices.size());
    const auto [entry, added] = midpoints_.try_emplace(std::minmax(from, to), fresh);
    if (added) {
      mesh_->vertices.push_back(
          (mesh_->vertices[from].normalized() + mesh_->vertices[to].normalized()).eval());
    }
    return entry->second;
  }

  TriangleMesh* mesh_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> midpoints_;
};

using CubePoint = std::array<int, 3>;  ///< of the grid on the cube's sides, each from 0 to cells

/// A point of the cube ±1 on the unit ball, cells of nearly equal size. (Nowell 2005)
Vector3 on_ball(const Vector3& cube) {
  const Vector3 square = cube.cwiseProduct(cube);
  const auto stretched = [&](int axis, int other, int third) {
    return cube[axis] * std::sqrt(1.0 - 0.5 * (square[other] + square[third]) +
                                  square[other] * square[third] / 3.0);
  };
  return Vector3(stretched(0, 1, 2), stretched(1, 2, 0), stretched(2, 0, 1)).normalized();
}

/// The ball's vertices and triangles, side by side of the cube.
class BallMaker {
 public:
  explicit BallMaker(int cells) : cells_(cells) {}

  TriangleMesh made() {
    for (int axis = 0; axis < 3; ++axis) {
      add_side(axis, 0);
      add_side(axis, cells_);
    }
    return std::move(mesh_);
  }

 private:
  void add_side(int axis, int height) {
    for (int row = 0; row < cells_; ++row) {
      for (int column = 0; column < cells_; ++column) {
        add_cell(axis, height, row, column);
      }
    }
  }

  /// Two triangles, outward: the axes after `axis` turn anticlockwise seen from its end. Along the
  /// diagonal that leaves no dent.
  void add_cell(int axis, int height, int row, int column) {
    const auto corner = [&](int across, int up) {
      CubePoint point{};
      point[static_cast<std::size_t>(axis)] = height;
      point[static_cast<std::size_t>((axis + 1) % 3)] = row + across;
      point[static_cast<std::size_t>((axis + 2) % 3)] = column + up;
      return vertex(point);
    };
    const std::array<std::uint32_t, 4> round{corner(0, 0), corner(1, 0), corner(1, 1),
                                             corner(0, 1)};
    const bool flipped = height == 0;
    const std::size_t from = is_convex(round, flipped) ? 0 : 1;
    add_triangle(round[from], round[from + 1], round[from + 2], flipped);
    add_triangle(round[from], round[from + 2], round[(from + 3) % 4], flipped);
  }

  /// Whether the last corner lies below the plane of the others, seen from outside, or in it.
  [[nodiscard]] bool is_convex(const std::array<std::uint32_t, 4>& round, bool flipped) const {
    const Vector3& first = mesh_.vertices[round[0]];
    const Vector3 normal =
        (mesh_.vertices[round[1]] - first).cross(mesh_.vertices[round[2]] - first);
    const double height = normal.dot(mesh_.vertices[round[3]] - first);
    return flipped ? height >= 0.0 : height <= 0.0;
  }

  void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c, bool flipped) {
    if (flipped) {
      mesh_.triangles.push_back({a, c, b});
    } else {
      mesh_.triangles.push_back({a, b, c});
    }
  }

  std::uint32_t vertex(const CubePoint& point) {
    const auto fresh = static_cast<std::uint32_t>(mesh_.vertices.size());
    const auto [entry, added] = known_.try_emplace(point, fresh);
    if (added) {
      const auto place = [&](std::size_t axis) {
        return static_cast<double>(2 * point[axis] - cells_) / cells_;
      };
      mesh_.vertices.push_back(on_ball({place(0), place(1), place(2)}));
    }
    return entry->second;
  }

  int cells_;
  TriangleMesh mesh_;
  std::map<CubePoint, std::uint32_t> known_;
};

}  // namespace

TriangleMesh icosphere_mesh(double radius_m, int subdivisions) {
  assert(subdivisions >= 0 && subdivisions <= 7);
  TriangleMesh mesh = icosahedron();
  for (int round = 0; round < subdivisions; ++round) {
    Splitter(mesh).split_all();
  }
  for (Vector3& vertex : mesh.vertices) {
    vertex = radius_m * vertex.normalized();
  }
  return mesh;
}

double swept_inner_radius_m(const TriangleMesh& mesh, const Vector3& half_u_m,
                            const Vector3& half_v_m) {
  double least_m = std::numeric_limits<double>::infinity();
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vector3& corner = mesh.vertices[a];
    const Vector3 normal =
        (mesh.vertices[b] - corner).cross(mesh.vertices[c] - corner).normalized();
    const double core_m = std::abs(normal.dot(half_u_m)) + std::abs(normal.dot(half_v_m));
    least_m = std::min(least_m, normal.dot(corner) - core_m);
  }
  return least_m;
}

TriangleMesh swept_mesh(double half_x_m, double half_y_m, double radius_m, int cells) {
  assert(half_x_m >= 0.0 && half_y_m >= 0.0 && radius_m > 0.0 && cells > 0 && cells % 2 == 1);
  TriangleMesh mesh = BallMaker(cells).made();
  for (Vector3& vertex : mesh.vertices) {
    const Vector3 corner(std::copysign(half_x_m, vertex.x()), std::copysign(half_y_m, vertex.y()),
                         0.0);
    vertex = (corner + radius_m * vertex).eval();
  }
  return mesh;
}

}  // namespace impetus::inline shapes
