// SPDX-License-Identifier: MIT
#include "tests/bench/pair_poses.hpp"

#include "engine/shapes/mesh_distance.hpp"

namespace impetus {
namespace {

using Box3 = Eigen::AlignedBox3d;

Box3 box_of(const TriangleMesh& mesh) {
  Box3 box;
  for (const Vector3& vertex : mesh.vertices) {
    box.extend(vertex);
  }
  return box;
}

TriangleMesh within(const TriangleMesh& mesh, const Box3& room) {
  TriangleMesh kept{mesh.vertices, {}};
  for (const auto& [a, b, c] : mesh.triangles) {
    Box3 box(mesh.vertices[a]);
    box.extend(mesh.vertices[b]);
    box.extend(mesh.vertices[c]);
    if (room.intersects(box)) {
      kept.triangles.push_back({a, b, c});
    }
  }
  return kept;
}

}  // namespace

bool crosses_itself_at(const TriangleMesh& mesh, const Pose& pose) {
  TriangleMesh moved = mesh;
  for (Vector3& vertex : moved.vertices) {
    vertex = pose.transform(vertex);
  }
  const Box3 shared = box_of(mesh).intersection(box_of(moved));
  return !shared.isEmpty() && intersects(within(mesh, shared), {}, within(moved, shared), {});
}

std::vector<PairPose> random_pair_poses(const TriangleMesh& mesh, int count, double reach_m) {
  RandomStream random(/*seed=*/6, "pair poses");
  std::vector<PairPose> poses(static_cast<std::size_t>(count));
  for (PairPose& pose : poses) {
    do {
      pose.b.position = reach_m * random_in_unit_cube(random);
    } while (pose.b.position.norm() > reach_m);
    pose.b.orientation = random_orientation(random);
    pose.surfaces_cross = crosses_itself_at(mesh, pose.b);
  }
  return poses;
}

}  // namespace impetus
