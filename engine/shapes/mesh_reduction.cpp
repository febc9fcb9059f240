// SPDX-License-Identifier: MIT
#include "engine/shapes/mesh_reduction.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

namespace impetus::inline shapes {
namespace {

/// A triangle may turn by no more than this when a corner of it moves.
constexpr double kLeastTurnCosine = 0.2;
/// Twice the area of a triangle over its longest side squared: below it is no triangle any more.
constexpr double kThinnest = 1e-3;
/// How much a vertex's own place weighs beside the planes about it: it decides where these do not,
/// within flat ground and along straight edges.
constexpr double kPlaceWeight = 1e-4;

/// The sum of weighted squared distances to planes and points, x ↦ xᵀAx + 2bᵀx + c.
struct Quadric {
  Matrix3 a{Matrix3::Zero()};
  Vector3 b{Vector3::Zero()};
  double c{0.0};

  void add_plane(const Vector3& normal, double offset, double weight) {
    const Vector3 weighted = weight * normal;
    a += weighted * normal.transpose();
    b -= offset * weighted;
    c += weight * offset * offset;
  }
  void add_point(const Vector3& point, double weight) {
    a += weight * Matrix3::Identity();
    b -= weight * point;
    c += weight * point.squaredNorm();
  }
  void add(const Quadric& other) {
    a += other.a;
    b += other.b;
    c += other.c;
  }
  [[nodiscard]] double at(const Vector3& x) const { return x.dot(a * x) + 2.0 * b.dot(x) + c; }
};

/// The x of least value, by Cramer's rule: A is positive definite for the points that are in it.
Vector3 least_of(const Quadric& quadric) {
  const Vector3 column0 = quadric.a.col(0);
  const Vector3 column1 = quadric.a.col(1);
  const Vector3 column2 = quadric.a.col(2);
  const Vector3 cross12 = column1.cross(column2);
  const double determinant = column0.dot(cross12);
  const Vector3 target = -quadric.b;
  return Vector3(target.dot(cross12), column0.dot(target.cross(column2)),
                 column0.dot(column1.cross(target))) /
         determinant;
}

/// An edge that could go, as things stood when both its ends had been changed so often.
struct Candidate {
  double cost;
  std::uint32_t u;
  std::uint32_t v;
  int u_changes;
  int v_changes;
  Vector3 target;
};

/// The cheapest candidate first; of equals the first edge.
struct Dearer {
  bool operator()(const Candidate& a, const Candidate& b) const {
    return std::tie(a.cost, a.u, a.v) > std::tie(b.cost, b.u, b.v);
  }
};

/// A mesh while its edges are drawn together.
class Reduction {
 public:
  explicit Reduction(const TriangleMesh& mesh)
      : mesh_(mesh),
        origin_(mesh.vertices[mesh.triangles.front()[0]]),
        left_(mesh.triangles.size()),
        gone_(mesh.triangles.size(), 0),
        triangles_at_(mesh.vertices.size()),
        quadrics_(mesh.vertices.size()),
        changes_(mesh.vertices.size(), 0) {
    for (std::uint32_t triangle = 0; triangle < mesh_.triangles.size(); ++triangle) {
      add_triangle(triangle);
    }
    for (const auto& [a, b, c] : mesh_.triangles) {
      for (const auto& [u, v] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
        if (u < v) {
          propose(u, v);
        }
      }
    }
  }

  TriangleMesh reduced_to(std::size_t triangles) {
    while (left_ > triangles && !candidates_.empty()) {
      const Candidate candidate = candidates_.top();
      candidates_.pop();
      if (candidate.u_changes == changes_[candidate.u] &&
          candidate.v_changes == changes_[candidate.v] && may_go(candidate)) {
        draw_together(candidate);
      }
    }
    return remaining();
  }

 private:
  void add_triangle(std::uint32_t index) {
    const auto& triangle = mesh_.triangles[index];
    const Vector3 a = mesh_.vertices[triangle[0]] - origin_;
    const Vector3 doubled = doubled_area_of(index, triangle[0], mesh_.vertices[triangle[0]]);
    const double area_m2 = 0.5 * doubled.norm();
    const Vector3 normal = doubled.normalized();
    for (const std::uint32_t vertex : triangle) {
      triangles_at_[vertex].push_back(index);
      quadrics_[vertex].add_plane(normal, normal.dot(a), area_m2);
      quadrics_[vertex].add_point(mesh_.vertices[vertex] - origin_, kPlaceWeight * area_m2);
    }
  }

  /// Of a triangle with one of its vertices at another place.
  [[nodiscard]] std::array<Vector3, 3> moved(std::uint32_t index, std::uint32_t vertex,
                                             const Vector3& place) const {
    std::array<Vector3, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t here = mesh_.triangles[index][i];
      corners[i] = here == vertex ? place : mesh_.vertices[here];
    }
    return corners;
  }

  [[nodiscard]] Vector3 doubled_area_of(std::uint32_t index, std::uint32_t vertex,
                                        const Vector3& place) const {
    const auto [a, b, c] = moved(index, vertex, place);
    return (b - a).cross(c - a);
  }

  void propose(std::uint32_t u, std::uint32_t v) {
    Quadric sum = quadrics_[u];
    sum.add(quadrics_[v]);
    const Vector3 target = least_of(sum);
    if (target.allFinite()) {
      candidates_.push(
          {std::max(0.0, sum.at(target)), u, v, changes_[u], changes_[v], origin_ + target});
    }
  }

  [[nodiscard]] std::vector<std::uint32_t> neighbours_of(std::uint32_t vertex) const {
    std::vector<std::uint32_t> neighbours;
    for (const std::uint32_t index : triangles_at_[vertex]) {
      for (const std::uint32_t other : mesh_.triangles[index]) {
        if (other != vertex) {
          neighbours.push_back(other);
        }
      }
    }
    std::sort(neighbours.begin(), neighbours.end());
    neighbours.erase(std::unique(neighbours.begin(), neighbours.end()), neighbours.end());
    return neighbours;
  }

  /// The link condition: the ends share two neighbours, those across the edge, and neither of them
  /// would be left with two triangles back to back.
  [[nodiscard]] bool stays_manifold(const Candidate& edge) const {
    const std::vector<std::uint32_t> of_u = neighbours_of(edge.u);
    const std::vector<std::uint32_t> of_v = neighbours_of(edge.v);
    std::vector<std::uint32_t> shared;
    std::set_intersection(of_u.begin(), of_u.end(), of_v.begin(), of_v.end(),
                          std::back_inserter(shared));
    return shared.size() == 2 && triangles_at_[shared[0]].size() > 3 &&
           triangles_at_[shared[1]].size() > 3;
  }

  [[nodiscard]] bool has(std::uint32_t index, std::uint32_t vertex) const {
    const auto& triangle = mesh_.triangles[index];
    return std::find(triangle.begin(), triangle.end(), vertex) != triangle.end();
  }

  /// Whether a triangle at `vertex` that stays would turn over or wither when it moves.
  [[nodiscard]] bool turns_any(std::uint32_t vertex, std::uint32_t other,
                               const Vector3& target) const {
    return std::any_of(
        triangles_at_[vertex].begin(), triangles_at_[vertex].end(), [&](std::uint32_t index) {
          if (has(index, other)) {
            return false;
          }
          const Vector3 before = doubled_area_of(index, vertex, mesh_.vertices[vertex]);
          const Vector3 after = doubled_area_of(index, vertex, target);
          const auto [a, b, c] = moved(index, vertex, target);
          const double longest_squared =
              std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
          return before.dot(after) < kLeastTurnCosine * before.norm() * after.norm() ||
                 after.norm() <= kThinnest * longest_squared;
        });
  }

  [[nodiscard]] bool may_go(const Candidate& edge) const {
    return stays_manifold(edge) && !turns_any(edge.u, edge.v, edge.target) &&
           !turns_any(edge.v, edge.u, edge.target);
  }

  void draw_together(const Candidate& edge) {
    const auto [u, v] = std::pair(edge.u, edge.v);
    for (const std::uint32_t index : std::vector(triangles_at_[v])) {
      if (has(index, u)) {
        remove(index);
      } else {
        auto& triangle = mesh_.triangles[index];
        *std::find(triangle.begin(), triangle.end(), v) = u;
        triangles_at_[u].push_back(index);
      }
    }
    triangles_at_[v].clear();
    mesh_.vertices[u] = edge.target;
    quadrics_[u].add(quadrics_[v]);
    ++changes_[u];
    ++changes_[v];
    for (const std::uint32_t neighbour : neighbours_of(u)) {
      propose(std::min(u, neighbour), std::max(u, neighbour));
    }
  }

  void remove(std::uint32_t index) {
    for (const std::uint32_t vertex : mesh_.triangles[index]) {
      auto& here = triangles_at_[vertex];
      here.erase(std::find(here.begin(), here.end(), index));
    }
    gone_[index] = 1;
    --left_;
  }

  [[nodiscard]] TriangleMesh remaining() const {
    TriangleMesh result;
    std::vector<std::uint32_t> renamed(mesh_.vertices.size());
    for (std::size_t vertex = 0; vertex < mesh_.vertices.size(); ++vertex) {
      if (!triangles_at_[vertex].empty()) {
        renamed[vertex] = static_cast<std::uint32_t>(result.vertices.size());
        result.vertices.push_back(mesh_.vertices[vertex]);
      }
    }
    for (std::size_t index = 0; index < mesh_.triangles.size(); ++index) {
      const auto& [a, b, c] = mesh_.triangles[index];
      if (gone_[index] == 0) {
        result.triangles.push_back({renamed[a], renamed[b], renamed[c]});
      }
    }
    return result;
  }

  TriangleMesh mesh_;
  Vector3 origin_;  ///< of the quadrics: far from it their terms would cancel
  std::size_t left_;
  std::vector<char> gone_;
  std::vector<std::vector<std::uint32_t>> triangles_at_;  ///< by vertex
  std::vector<Quadric> quadrics_;                         ///< by vertex
  std::vector<int> changes_;
  std::priority_queue<Candidate, std::vector<Candidate>, Dearer> candidates_;
};

}  // namespace

TriangleMesh reduced_mesh(const TriangleMesh& mesh, std::size_t triangles) {
  if (mesh.triangles.size() <= triangles) {
    return mesh;
  }
  return Reduction(mesh).reduced_to(triangles);
}

}  // namespace impetus::inline shapes
