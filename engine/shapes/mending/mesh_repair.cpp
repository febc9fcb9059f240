// SPDX-License-Identifier: MIT
#include "engine/shapes/mending/mesh_repair.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "engine/shapes/mesh_components.hpp"

namespace impetus::inline shapes {
namespace {

using Corners = std::array<std::uint32_t, 3>;
using Edge = std::pair<std::uint32_t, std::uint32_t>;
using Cell = std::array<std::int64_t, 3>;

constexpr std::uint32_t kUnnumbered = std::numeric_limits<std::uint32_t>::max();

void turn(Corners& triangle) { std::swap(triangle[1], triangle[2]); }

/// The vertices met so far, by cells as wide as the welding distance.
class NearVertices {
 public:
  NearVertices(const TriangleMesh& mesh, double distance_m)
      : mesh_(mesh), distance_m_(distance_m) {}

  /// The first vertex within the distance; `vertex` itself, now kept, when there is none.
  std::uint32_t stand_in(std::uint32_t vertex) {
    const Vector3 place = mesh_.vertices[vertex] - mesh_.vertices.front();
    const Cell own{cell(place.x()), cell(place.y()), cell(place.z())};
    for (std::int64_t i = 0; i < 27; ++i) {
      const auto [first, last] =
          kept_.equal_range({own[0] + i % 3 - 1, own[1] + i / 3 % 3 - 1, own[2] + i / 9 - 1});
      for (auto near = first; near != last; ++near) {
        if ((mesh_.vertices[near->second] - mesh_.vertices[vertex]).norm() <= distance_m_) {
          return near->second;
        }
      }
    }
    kept_.emplace(own, vertex);
    return vertex;
  }

 private:
  [[nodiscard]] std::int64_t cell(double coordinate_m) const {
    return static_cast<std::int64_t>(std::floor(coordinate_m / distance_m_));
  }

  const TriangleMesh& mesh_;
  double distance_m_;
  std::multimap<Cell, std::uint32_t> kept_;
};

std::int64_t weld(TriangleMesh& mesh) {
  const double distance_m = kWeldingDistance * bounds_of(mesh.vertices).sides().norm();
  if (distance_m == 0.0) {
    return 0;
  }
  NearVertices near(mesh, distance_m);
  std::vector<std::uint32_t> stand_in;
  std::int64_t welded = 0;
  for (std::uint32_t vertex = 0; vertex < mesh.vertices.size(); ++vertex) {
    stand_in.push_back(near.stand_in(vertex));
    welded += stand_in.back() == vertex ? 0 : 1;
  }
  for (Corners& triangle : mesh.triangles) {
    for (std::uint32_t& corner : triangle) {
      corner = stand_in[corner];
    }
  }
  return welded;
}

/// Turns triangles until neighbours agree, in each component the fewer ones.
class Alignment {
 public:
  explicit Alignment(TriangleMesh& mesh) : mesh_(mesh), turned_(mesh.triangles.size(), kUnknown) {
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t from = mesh.triangles[t][i];
        const std::uint32_t to = mesh.triangles[t][(i + 1) % 3];
        sides_[std::minmax(from, to)].push_back({t, from < to});
      }
    }
  }

  /// The number of triangles turned; below zero when the surface has one side only.
  std::int64_t run() {
    std::int64_t count = 0;
    for (std::uint32_t first = 0; first < turned_.size(); ++first) {
      if (turned_[first] == kUnknown) {
        count += align_component(first);
      }
    }
    return one_sided_ ? -1 : count;
  }

 private:
  enum Turned : std::int8_t { kUnknown, kKept, kTurned };
  struct Side {
    std::uint32_t triangle;
    bool forward;
  };

  std::int64_t align_component(std::uint32_t first) {
    std::vector<std::uint32_t> members{first};
    turned_[first] = kKept;
    for (std::size_t next = 0; next < members.size(); ++next) {
      visit_neighbours(members[next], members);
    }
    const auto turned = std::count_if(members.begin(), members.end(),
                                      [this](std::uint32_t t) { return turned_[t] == kTurned; });
    const auto size = static_cast<std::ptrdiff_t>(members.size());
    const Turned fewer = 2 * turned <= size ? kTurned : kKept;
    for (const std::uint32_t t : members) {
      if (turned_[t] == fewer) {
        turn(mesh_.triangles[t]);
      }
    }
    return std::min<std::int64_t>(turned, size - turned);
  }

  void visit_neighbours(std::uint32_t triangle, std::vector<std::uint32_t>& members) {
    const Corners corners = mesh_.triangles[triangle];
    for (std::size_t i = 0; i < 3; ++i) {
      const std::vector<Side>& sides = sides_[std::minmax(corners[i], corners[(i + 1) % 3])];
      if (sides.size() != 2) {
        continue;
      }
      const Side& other = sides[sides[0].triangle == triangle ? 1 : 0];
      const bool agrees = sides[0].forward != sides[1].forward;
      const Turned wanted = (turned_[triangle] == kTurned) == agrees ? kTurned : kKept;
      if (turned_[other.triangle] == kUnknown) {
        turned_[other.triangle] = wanted;
        members.push_back(other.triangle);
      } else if (turned_[other.triangle] != wanted) {
        one_sided_ = true;
      }
    }
  }

  TriangleMesh& mesh_;
  std::vector<Turned> turned_;
  std::map<Edge, std::vector<Side>> sides_;
  bool one_sided_{false};
};

std::int64_t turn_components(TriangleMesh& mesh) {
  const MeshComponents components = find_components(mesh);
  const ComponentOrientation orientation = orientation_of(mesh, components);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (orientation.turned[components.of_triangle[t]]) {
      turn(mesh.triangles[t]);
    }
  }
  return std::count(orientation.turned.begin(), orientation.turned.end(), true);
}

void drop_unused_vertices(TriangleMesh& mesh) {
  std::vector<std::uint32_t> number(mesh.vertices.size(), kUnnumbered);
  std::vector<Vector3> used;
  for (Corners& triangle : mesh.triangles) {
    for (std::uint32_t& corner : triangle) {
      if (number[corner] == kUnnumbered) {
        number[corner] = static_cast<std::uint32_t>(used.size());
        used.push_back(mesh.vertices[corner]);
      }
      corner = number[corner];
    }
  }
  mesh.vertices = std::move(used);
}

void stop(MeshRepair& result, RepairObstacle obstacle, std::int64_t how_many = 1) {
  if (result.obstacle == RepairObstacle::kNone && how_many > 0) {
    result.obstacle = obstacle;
    result.obstacles = how_many;
  }
}

void close(MeshRepair& result) {
  if (result.mesh.triangles.empty()) {
    return stop(result, RepairObstacle::kNothingLeft);
  }
  stop(result, RepairObstacle::kCrowdedEdges, find_defects(result.mesh).crowded_edges);
  if (result.obstacle != RepairObstacle::kNone) {
    return;
  }
  result.triangles_turned = Alignment(result.mesh).run();
  if (result.triangles_turned < 0) {
    result.triangles_turned = 0;
    return stop(result, RepairObstacle::kOneSided);
  }
  result.filling = fill_holes(result.mesh);
  stop(result, RepairObstacle::kLargeHoles, result.filling.large_holes);
  stop(result, RepairObstacle::kStuckHoles, result.filling.stuck_holes);
}

}  // namespace

MeshRepair repair(TriangleMesh mesh) {
  MeshRepair result;
  result.mesh = std::move(mesh);
  if (find_defects(result.mesh).open_edges > 0) {
    result.vertices_welded = weld(result.mesh);
  }
  result.degenerate_dropped = drop_degenerate(result.mesh);
  result.duplicate_dropped = drop_duplicates(result.mesh);
  close(result);
  drop_unused_vertices(result.mesh);
  if (result.obstacle == RepairObstacle::kNone && find_defects(result.mesh).none()) {
    result.components_turned = turn_components(result.mesh);
  }
  return result;
}

}  // namespace impetus::inline shapes
