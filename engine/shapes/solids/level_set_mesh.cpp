// SPDX-License-Identifier: MIT
#include "engine/shapes/solids/level_set_mesh.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

namespace impetus::inline shapes {
namespace {

/// The least distance of a vertex from a point of the grid, as a share of the edge it lies on.
constexpr double kClearance = 0.1;

using Triple = std::array<std::uint32_t, 3>;

/// The orders in which a path along a cube's edges may take the three axes; the first three are
/// even permutations, whose tetrahedra are positively oriented.
constexpr std::array<std::array<int, 3>, 6> kPaths{
    {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {1, 0, 2}, {2, 1, 0}}};

/// Even permutations of a tetrahedron's corners, by the two that come first.
constexpr std::array<std::array<std::size_t, 4>, 6> kPairs{
    {{0, 1, 2, 3}, {0, 2, 3, 1}, {0, 3, 1, 2}, {1, 2, 0, 3}, {1, 3, 2, 0}, {2, 3, 0, 1}}};

/// The surface in the making, tetrahedron by tetrahedron.
class Surface {
 public:
  Surface(const std::function<double(const Vector3&)>& value, const SampleGrid& grid)
      : grid_(grid),
        strides_{1, static_cast<std::size_t>(grid.cells[0] + 1),
                 static_cast<std::size_t>(grid.cells[0] + 1) *
                     static_cast<std::size_t>(grid.cells[1] + 1)} {
    for (int z = 0; z <= grid.cells[2]; ++z) {
      for (int y = 0; y <= grid.cells[1]; ++y) {
        for (int x = 0; x <= grid.cells[0]; ++x) {
          points_.emplace_back(grid.least + grid.cell_m * Vector3(x, y, z));
          values_.push_back(value(points_.back()));
          assert(!negative(points_.size() - 1) || within(x, y, z));
        }
      }
    }
    vertex_on_edge_.assign(8 * points_.size(), kNone);
  }

  TriangleMesh made() {
    for (int z = 0; z < grid_.cells[2]; ++z) {
      for (int y = 0; y < grid_.cells[1]; ++y) {
        for (int x = 0; x < grid_.cells[0]; ++x) {
          add_cube(static_cast<std::size_t>(x) + static_cast<std::size_t>(y) * strides_[1] +
                   static_cast<std::size_t>(z) * strides_[2]);
        }
      }
    }
    return std::move(mesh_);
  }

 private:
  static constexpr std::uint32_t kNone = 0xffffffff;

  /// A corner of a tetrahedron: its point, and which axes lead there from the cube's least corner.
  struct Corner {
    std::size_t point;
    std::size_t axes;
  };
  using Tetrahedron = std::array<Corner, 4>;

  [[nodiscard]] bool within(int x, int y, int z) const {
    return x > 0 && y > 0 && z > 0 && x < grid_.cells[0] && y < grid_.cells[1] &&
           z < grid_.cells[2];
  }

  [[nodiscard]] bool negative(std::size_t point) const { return values_[point] < 0.0; }

  void add_cube(std::size_t least) {
    for (std::size_t path = 0; path < kPaths.size(); ++path) {
      Tetrahedron corners{{{least, 0}, {}, {}, {}}};
      for (std::size_t step = 0; step < 3; ++step) {
        const auto axis = static_cast<std::size_t>(kPaths[path][step]);
        corners[step + 1] = {corners[step].point + strides_[axis],
                             corners[step].axes | (std::size_t{1} << axis)};
      }
      add_tetrahedron(corners, /*positive=*/path < 3);
    }
  }

  void add_tetrahedron(const Tetrahedron& corners, bool positive) {
    std::array<bool, 4> inside{};
    int count = 0;
    for (std::size_t corner = 0; corner < 4; ++corner) {
      inside[corner] = negative(corners[corner].point);
      count += inside[corner] ? 1 : 0;
    }
    if (count == 1 || count == 3) {
      const bool lone_inside = count == 1;
      const auto lone = static_cast<std::size_t>(
          std::find(inside.begin(), inside.end(), lone_inside) - inside.begin());
      add_triangle({vertex(corners, lone, lone ^ 1), vertex(corners, lone, lone ^ 2),
                    vertex(corners, lone, lone ^ 3)},
                   positive == lone_inside);
    } else if (count == 2) {
      for (const auto& [a, b, c, d] : kPairs) {
        if (inside[a] && inside[b]) {
          add_quadrilateral({vertex(corners, a, c), vertex(corners, a, d), vertex(corners, b, d),
                             vertex(corners, b, c)},
                            positive);
        }
      }
    }
  }

  void add_triangle(const Triple& triangle, bool as_listed) {
    const auto& [a, b, c] = triangle;
    mesh_.triangles.push_back(as_listed ? triangle : Triple{a, c, b});
  }

  /// Cut along its shorter diagonal.
  void add_quadrilateral(const std::array<std::uint32_t, 4>& corners, bool as_listed) {
    const auto& [a, b, c, d] = corners;
    const auto squared_length = [&](std::uint32_t from, std::uint32_t to) {
      return (mesh_.vertices[to] - mesh_.vertices[from]).squaredNorm();
    };
    if (squared_length(a, c) <= squared_length(b, d)) {
      add_triangle({a, b, c}, as_listed);
      add_triangle({a, c, d}, as_listed);
    } else {
      add_triangle({a, b, d}, as_listed);
      add_triangle({b, c, d}, as_listed);
    }
  }

  /// The surface's vertex on the edge between two corners, made when first asked for.
  std::uint32_t vertex(const Tetrahedron& corners, std::size_t one, std::size_t other) {
    const Corner& from = corners[std::min(one, other)];
    const Corner& to = corners[std::max(one, other)];
    std::uint32_t& known = vertex_on_edge_[8 * from.point + (to.axes ^ from.axes)];
    if (known == kNone) {
      const double at = values_[from.point] / (values_[from.point] - values_[to.point]);
      known = static_cast<std::uint32_t>(mesh_.vertices.size());
      mesh_.vertices.emplace_back(points_[from.point] +
                                  std::clamp(at, kClearance, 1.0 - kClearance) *
                                      (points_[to.point] - points_[from.point]));
    }
    return known;
  }

  SampleGrid grid_;
  std::array<std::size_t, 3> strides_;
  std::vector<Vector3> points_;
  std::vector<double> values_;
  std::vector<std::uint32_t> vertex_on_edge_;  ///< by the edge's least point and its direction
  TriangleMesh mesh_;
};

}  // namespace

TriangleMesh level_set_mesh(const std::function<double(const Vector3&)>& value,
                            const SampleGrid& grid) {
  return Surface(value, grid).made();
}

}  // namespace impetus::inline shapes
