// SPDX-License-Identifier: MIT
#include "engine/trees/solid_grid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "engine/volumes/rounded_box.hpp"

namespace impetus::inline trees {
namespace {

using Cells = Eigen::Array3i;

/// Centres are shifted by an odd share of a cell: meshes have edges and corners on round numbers,
/// and a line along z must not run through one.
constexpr std::array<double, 3> kShift{0.4871, 0.5093, 0.5};

/// Cells of equal size over a box.
struct Grid {
  Vector3 least;
  double cell_m;
  Cells count;

  [[nodiscard]] double centre(int axis, int cell) const {
    return least[axis] + (cell + kShift[static_cast<std::size_t>(axis)]) * cell_m;
  }
  /// The first cell along an axis whose centre is not below `at`, kept within 0 and the count.
  [[nodiscard]] int first_from(int axis, double at) const {
    const double cell = (at - least[axis]) / cell_m - kShift[static_cast<std::size_t>(axis)];
    return static_cast<int>(std::clamp(std::ceil(cell), 0.0, static_cast<double>(count[axis])));
  }
  [[nodiscard]] std::size_t column(int x, int y) const {
    return static_cast<std::size_t>(x) * static_cast<std::size_t>(count.y()) +
           static_cast<std::size_t>(y);
  }
};

Grid grid_over(const std::vector<RoundedBox>& forms, int divisions) {
  Eigen::AlignedBox3d bounds;
  for (const RoundedBox& form : forms) {
    bounds.extend(Vector3(form.centre - upright_reach_m(form)));
    bounds.extend(Vector3(form.centre + upright_reach_m(form)));
  }
  const double cell_m = bounds.sizes().maxCoeff() / divisions;
  const Cells count = (bounds.sizes() / cell_m).array().ceil().cast<int>();
  return {bounds.min(), cell_m, count.max(1)};
}

/// Where a column's line passes through the surface: up through it or down.
using Crossing = std::pair<double, int>;

/// Twice the area of (a, b, p) seen along z, the same bits but for the sign from either end.
double side_of_edge(const Vector3& a, const Vector3& b, double x, double y) {
  if (std::pair(b.x(), b.y()) < std::pair(a.x(), a.y())) {
    return -side_of_edge(b, a, x, y);
  }
  return (b.x() - a.x()) * (y - a.y()) - (b.y() - a.y()) * (x - a.x());
}

void add_crossings(const Grid& grid, const std::array<Vector3, 3>& corners,
                   std::vector<std::vector<Crossing>>& columns) {
  const auto& [a, b, c] = corners;
  const Vector3 least = a.cwiseMin(b).cwiseMin(c);
  const Vector3 most = a.cwiseMax(b).cwiseMax(c);
  for (int x = grid.first_from(0, least.x()); x < grid.first_from(0, most.x()); ++x) {
    for (int y = grid.first_from(1, least.y()); y < grid.first_from(1, most.y()); ++y) {
      const double at_x = grid.centre(0, x);
      const double at_y = grid.centre(1, y);
      const double to_c = side_of_edge(a, b, at_x, at_y);
      const double to_a = side_of_edge(b, c, at_x, at_y);
      const double to_b = side_of_edge(c, a, at_x, at_y);
      const bool up = to_a > 0.0 && to_b > 0.0 && to_c > 0.0;
      const bool down = to_a < 0.0 && to_b < 0.0 && to_c < 0.0;
      if (up || down) {
        const double z = (to_a * a.z() + to_b * b.z() + to_c * c.z()) / (to_a + to_b + to_c);
        columns[grid.column(x, y)].emplace_back(z, up ? -1 : 1);
      }
    }
  }
}

/// For each column the crossings with the surface, from below. A surface that faces down is
/// entered (+1).
std::vector<std::vector<Crossing>> crossings_of(const Grid& grid, const TriangleMesh& solid) {
  std::vector<std::vector<Crossing>> columns(grid.column(grid.count.x(), 0));
  for (const auto& [a, b, c] : solid.triangles) {
    add_crossings(grid, {solid.vertices[a], solid.vertices[b], solid.vertices[c]}, columns);
  }
  for (auto& column : columns) {
    std::sort(column.begin(), column.end());
  }
  return columns;
}

/// Counts cells, each once; those of the solid are taken first.
class Counter {
 public:
  Counter(const Grid& grid, const TriangleMesh& solid)
      : grid_(grid),
        taken_(grid.column(grid.count.x(), 0) * static_cast<std::size_t>(grid.count.z()), 0) {
    const auto columns = crossings_of(grid, solid);
    for (std::size_t column = 0; column < columns.size(); ++column) {
      take_inside(column, columns[column]);
    }
  }

  /// The cells in the volume that nothing has taken yet.
  std::int64_t take(const Volume& volume, const RoundedBox& form) {
    const Vector3 reach = upright_reach_m(form);
    const auto range = [&](int axis) {
      return std::pair(grid_.first_from(axis, form.centre[axis] - reach[axis]),
                       grid_.first_from(axis, form.centre[axis] + reach[axis]));
    };
    const auto [x_begin, x_end] = range(0);
    const auto [y_begin, y_end] = range(1);
    const auto [z_begin, z_end] = range(2);
    std::int64_t taken = 0;
    for (int x = x_begin; x < x_end; ++x) {
      for (int y = y_begin; y < y_end; ++y) {
        char* cells = column(grid_.column(x, y));
        for (int z = z_begin; z < z_end; ++z) {
          const Vector3 centre(grid_.centre(0, x), grid_.centre(1, y), grid_.centre(2, z));
          if (cells[z] == 0 && holds(volume, centre)) {
            cells[z] = 1;
            ++taken;
          }
        }
      }
    }
    return taken;
  }

 private:
  char* column(std::size_t index) {
    return taken_.data() + index * static_cast<std::size_t>(grid_.count.z());
  }

  void take_inside(std::size_t index, const std::vector<Crossing>& crossings) {
    int winding = 0;
    for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
      winding += crossings[i].second;
      if (winding > 0) {
        std::fill(column(index) + grid_.first_from(2, crossings[i].first),
                  column(index) + grid_.first_from(2, crossings[i + 1].first), 1);
      }
    }
  }

  const Grid& grid_;
  std::vector<char> taken_;
};

}  // namespace

double outside_volume_m3(const TriangleMesh& solid, const std::vector<Volume>& volumes,
                         int divisions) {
  std::vector<RoundedBox> forms;
  forms.reserve(volumes.size());
  for (const Volume& volume : volumes) {
    forms.push_back(rounded_box(volume));
  }
  const Grid grid = grid_over(forms, divisions);
  Counter counter(grid, solid);
  std::int64_t outside = 0;
  for (std::size_t i = 0; i < volumes.size(); ++i) {
    outside += counter.take(volumes[i], forms[i]);
  }
  return static_cast<double>(outside) * grid.cell_m * grid.cell_m * grid.cell_m;
}

}  // namespace impetus::inline trees
