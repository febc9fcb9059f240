// SPDX-License-Identifier: MIT
#include "engine/shapes/mending/hole_filling.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace impetus::inline shapes {
namespace {

using Loop = std::vector<std::uint32_t>;
using Edge = std::pair<std::uint32_t, std::uint32_t>;

constexpr double kImpossible = std::numeric_limits<double>::infinity();

/// Every edge of the mesh, in the direction in which a triangle runs along it.
std::set<Edge> directed_edges(const TriangleMesh& mesh) {
  std::set<Edge> edges;
  for (const auto& [a, b, c] : mesh.triangles) {
    edges.insert({{a, b}, {b, c}, {c, a}});
  }
  return edges;
}

/// The holes' edges in the direction in which the filling runs along them.
std::multimap<std::uint32_t, std::uint32_t> rim_of(const std::set<Edge>& edges) {
  std::multimap<std::uint32_t, std::uint32_t> rim;
  for (const auto& [from, to] : edges) {
    if (edges.count({to, from}) == 0) {
      rim.emplace(to, from);
    }
  }
  return rim;
}

/// Follows the rim; a vertex that comes again closes a loop.
std::vector<Loop> loops_of(std::multimap<std::uint32_t, std::uint32_t> rim) {
  std::vector<Loop> loops;
  while (!rim.empty()) {
    Loop path{rim.begin()->first};
    while (!path.empty()) {
      const auto next = rim.find(path.back());
      if (next == rim.end()) {
        break;  // back at the start: a vertex has as many edges in as out
      }
      const std::uint32_t vertex = next->second;
      rim.erase(next);
      const auto again = std::find(path.begin(), path.end(), vertex);
      if (again == path.end()) {
        path.push_back(vertex);
      } else {
        loops.emplace_back(again, path.end());
        path.erase(again + 1, path.end());
      }
    }
  }
  return loops;
}

/// The triangulation of least area of one loop.
class LoopFilling {
 public:
  LoopFilling(const TriangleMesh& mesh, const std::set<Edge>& edges, const Loop& loop)
      : mesh_(mesh), edges_(edges), loop_(loop), parts_(loop.size() * loop.size()) {
    for (std::size_t width = 2; width < loop.size(); ++width) {
      for (std::size_t i = 0; i + width < loop.size(); ++i) {
        part(i, i + width) = best(i, i + width);
      }
    }
  }

  [[nodiscard]] bool possible() const { return parts_[loop_.size() - 1].area_m2 < kImpossible; }

  void add_to(TriangleMesh& mesh) { add(mesh, 0, loop_.size() - 1); }

 private:
  /// The polygon of loop vertices i to j: its least area and the corner of the triangle on i–j.
  struct Part {
    double area_m2{0.0};
    std::size_t corner{0};
  };

  Part& part(std::size_t i, std::size_t j) { return parts_[i * loop_.size() + j]; }

  Part best(std::size_t i, std::size_t j) {
    Part least{kImpossible, i};
    const bool whole = i == 0 && j + 1 == loop_.size();
    if (!whole && (edges_.count({loop_[i], loop_[j]}) + edges_.count({loop_[j], loop_[i]}) > 0)) {
      return least;  // as a chord, this edge would have more than two triangles
    }
    for (std::size_t k = i + 1; k < j; ++k) {
      const std::array<std::uint32_t, 3> triangle{loop_[i], loop_[k], loop_[j]};
      const double area_m2 = is_degenerate(mesh_, triangle)
                                 ? kImpossible
                                 : part(i, k).area_m2 + part(k, j).area_m2 + area_of(triangle);
      if (area_m2 < least.area_m2) {
        least = {area_m2, k};
      }
    }
    return least;
  }

  [[nodiscard]] double area_of(const std::array<std::uint32_t, 3>& triangle) const {
    const Vector3& a = mesh_.vertices[triangle[0]];
    return (mesh_.vertices[triangle[1]] - a).cross(mesh_.vertices[triangle[2]] - a).norm() / 2.0;
  }

  void add(TriangleMesh& mesh, std::size_t i, std::size_t j) {
    if (j - i < 2) {
      return;
    }
    const std::size_t k = part(i, j).corner;
    mesh.triangles.push_back({loop_[i], loop_[k], loop_[j]});
    add(mesh, i, k);
    add(mesh, k, j);
  }

  const TriangleMesh& mesh_;
  const std::set<Edge>& edges_;
  const Loop& loop_;
  std::vector<Part> parts_;
};

/// Whether the loop runs round a single triangle.
bool is_triangle_of(const TriangleMesh& mesh, const Loop& loop) {
  return std::any_of(mesh.triangles.begin(), mesh.triangles.end(), [&loop](const auto& triangle) {
    return std::is_permutation(loop.begin(), loop.end(), triangle.begin(), triangle.end());
  });
}

}  // namespace

HoleFilling fill_holes(TriangleMesh& mesh) {
  HoleFilling result;
  std::set<Edge> edges = directed_edges(mesh);
  const std::size_t before = mesh.triangles.size();
  for (const Loop& loop : loops_of(rim_of(edges))) {
    const auto length = static_cast<std::int64_t>(loop.size());
    if (length > kLargestHole) {
      ++result.large_holes;
      continue;
    }
    LoopFilling filling(mesh, edges, loop);
    if (length < 3 || !filling.possible() || is_triangle_of(mesh, loop)) {
      ++result.stuck_holes;
      continue;
    }
    const std::size_t first = mesh.triangles.size();
    filling.add_to(mesh);
    for (std::size_t t = first; t < mesh.triangles.size(); ++t) {
      const auto& [a, b, c] = mesh.triangles[t];
      edges.insert({{a, b}, {b, c}, {c, a}});
    }
    ++result.holes;
    result.edges += length;
  }
  result.triangles = static_cast<std::int64_t>(mesh.triangles.size() - before);
  return result;
}

}  // namespace impetus::inline shapes
