// SPDX-License-Identifier: MIT
#include "engine/shapes/surface_distance.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <utility>

#include "engine/numerics/elementary_functions.hpp"

namespace impetus::inline shapes {
namespace {

constexpr std::uint32_t kLargestLeaf = 4;

double angle_rad(const Vector3& u, const Vector3& v) {
  return atan2_rad(u.cross(v).norm(), u.dot(v));
}

double squared_distance(const Vector3& least, const Vector3& most, const Vector3& point) {
  return (least - point).cwiseMax(point - most).cwiseMax(0.0).squaredNorm();
}

}  // namespace

SurfaceDistance::SurfaceDistance(const TriangleMesh& mesh)
    : mesh_(mesh), order_(mesh.triangles.size()) {
  assert(!mesh.triangles.empty());
  std::iota(order_.begin(), order_.end(), 0U);
  std::vector<Vector3> middles;
  middles.reserve(order_.size());
  for (std::uint32_t triangle = 0; triangle < order_.size(); ++triangle) {
    const auto [a, b, c] = corners(triangle);
    middles.push_back(0.5 * (a.cwiseMin(b).cwiseMin(c) + a.cwiseMax(b).cwiseMax(c)));
  }
  build(0, static_cast<std::uint32_t>(order_.size()), middles);
  for (const std::uint32_t triangle : order_) {
    in_order_.push_back(corners(triangle));
  }
  add_normals();
}

Triangle SurfaceDistance::corners(std::uint32_t triangle) const {
  const auto& [a, b, c] = mesh_.triangles[triangle];
  return {mesh_.vertices[a], mesh_.vertices[b], mesh_.vertices[c]};
}

void SurfaceDistance::build(std::uint32_t begin, std::uint32_t end,
                            const std::vector<Vector3>& middles) {
  Node node{corners(order_[begin])[0], corners(order_[begin])[0], begin, end, 0};
  for (std::uint32_t i = begin; i < end; ++i) {
    for (const Vector3& corner : corners(order_[i])) {
      node.least = node.least.cwiseMin(corner);
      node.most = node.most.cwiseMax(corner);
    }
  }
  const std::size_t index = nodes_.size();
  nodes_.push_back(node);
  if (end - begin <= kLargestLeaf) {
    return;
  }
  int axis = 0;
  (node.most - node.least).maxCoeff(&axis);
  const std::uint32_t middle = begin + (end - begin) / 2;
  // By the index among equals: whatever the library's algorithm, the halves are the same.
  std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                   [&](std::uint32_t a, std::uint32_t b) {
                     return std::pair(middles[a][axis], a) < std::pair(middles[b][axis], b);
                   });
  build(begin, middle, middles);
  nodes_[index].second_child = static_cast<std::uint32_t>(nodes_.size());
  build(middle, end, middles);
}

void SurfaceDistance::add_normals() {
  vertex_normals_.assign(mesh_.vertices.size(), Vector3::Zero());
  edge_normals_.assign(mesh_.triangles.size(), {Vector3::Zero(), Vector3::Zero(), Vector3::Zero()});
  std::map<std::pair<std::uint32_t, std::uint32_t>, Vector3> by_edge;
  const auto edge_of = [](const std::array<std::uint32_t, 3>& triangle, std::size_t i) {
    return std::minmax(triangle[i], triangle[(i + 1) % 3]);
  };
  for (std::uint32_t index = 0; index < mesh_.triangles.size(); ++index) {
    const Triangle at = corners(index);
    face_normals_.push_back((at[1] - at[0]).cross(at[2] - at[0]).normalized());
    const auto& triangle = mesh_.triangles[index];
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector3& normal = face_normals_.back();
      vertex_normals_[triangle[i]] +=
          angle_rad(at[(i + 1) % 3] - at[i], at[(i + 2) % 3] - at[i]) * normal;
      by_edge.try_emplace(edge_of(triangle, i), Vector3::Zero()).first->second += normal;
    }
  }
  for (std::size_t index = 0; index < mesh_.triangles.size(); ++index) {
    for (std::size_t i = 0; i < 3; ++i) {
      edge_normals_[index][i] = by_edge.at(edge_of(mesh_.triangles[index], i));
    }
  }
}

void SurfaceDistance::try_triangles(const Node& node, const Vector3& point, Found& best) const {
  for (std::uint32_t i = node.begin; i < node.end; ++i) {
    const auto [nearest, feature] = closest_feature(in_order_[i], point);
    const double squared_m2 = (nearest - point).squaredNorm();
    if (std::pair(squared_m2, order_[i]) < std::pair(best.squared_m2, best.triangle)) {
      best = {squared_m2, nearest, order_[i], feature};
    }
  }
}

void SurfaceDistance::search(std::uint32_t index, const Vector3& point, Found& best) const {
  const Node& node = nodes_[index];
  if (node.second_child == 0) {
    try_triangles(node, point, best);
    return;
  }
  std::array<std::uint32_t, 2> children{index + 1, node.second_child};
  std::array<double, 2> squared_m2{};
  for (std::size_t i = 0; i < 2; ++i) {
    const Node& child = nodes_[children[i]];
    squared_m2[i] = squared_distance(child.least, child.most, point);
  }
  const std::size_t first = squared_m2[0] <= squared_m2[1] ? 0 : 1;
  for (const std::size_t i : {first, 1 - first}) {
    if (squared_m2[i] <= best.squared_m2) {
      search(children[i], point, best);
    }
  }
}

SurfaceDistance::Found SurfaceDistance::find(const Vector3& point, std::uint32_t near) const {
  const auto [nearest, feature] = closest_feature(corners(near), point);
  Found best{(nearest - point).squaredNorm(), nearest, near, feature};
  search(0, point, best);
  return best;
}

NearestOnSurface SurfaceDistance::nearest(const Vector3& point, std::uint32_t near) const {
  const Found found = find(point, near);
  return {std::sqrt(found.squared_m2), found.point, found.triangle};
}

const Vector3& SurfaceDistance::pseudonormal(const Found& at) const {
  const auto feature = static_cast<std::size_t>(at.feature);
  if (feature < 3) {
    return vertex_normals_[mesh_.triangles[at.triangle][feature]];
  }
  return feature < 6 ? edge_normals_[at.triangle][feature - 3] : face_normals_[at.triangle];
}

std::vector<Triangle> SurfaceDistance::triangles_near(const Vector3& point, double radius_m) const {
  std::vector<Triangle> near;
  std::vector<std::uint32_t> open{0};
  while (!open.empty()) {
    const std::uint32_t index = open.back();
    const Node& node = nodes_[index];
    open.pop_back();
    if (squared_distance(node.least, node.most, point) > radius_m * radius_m) {
      continue;
    }
    if (node.second_child == 0) {
      near.insert(near.end(), in_order_.begin() + node.begin, in_order_.begin() + node.end);
    } else {
      open.push_back(node.second_child);
      open.push_back(index + 1);
    }
  }
  return near;
}

SignedDistance SurfaceDistance::signed_distance(const Vector3& point, std::uint32_t near) const {
  const Found found = find(point, near);
  const double distance_m = std::sqrt(found.squared_m2);
  const bool inside = pseudonormal(found).dot(point - found.point) < 0.0;
  return {inside ? -distance_m : distance_m, found.triangle};
}

double SurfaceDistance::signed_distance_m(const Vector3& point) const {
  return signed_distance(point).distance_m;
}

double SurfaceDistance::distance_to_m(std::uint32_t triangle, const Vector3& point) const {
  return (closest_on_triangle(corners(triangle), point) - point).norm();
}

bool contains(const TriangleMesh& solid, const Vector3& point) {
  // tan(Ω/2) = a·(b×c) / (|a||b||c| + a·b |c| + b·c |a| + c·a |b|)
  double half_angles = 0.0;
  for (const auto& triangle : solid.triangles) {
    const Vector3 a = solid.vertices[triangle[0]] - point;
    const Vector3 b = solid.vertices[triangle[1]] - point;
    const Vector3 c = solid.vertices[triangle[2]] - point;
    const double la = a.norm();
    const double lb = b.norm();
    const double lc = c.norm();
    half_angles +=
        atan2_rad(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return half_angles > std::numbers::pi;  // 2π inside, 0 outside
}

}  // namespace impetus::inline shapes
