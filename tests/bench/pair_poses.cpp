// SPDX-License-Identifier: MIT
#include "tests/bench/pair_poses.hpp"

#include "engine/shapes/mesh_distance.hpp"
#include "tests/engine/mesh_oracles.hpp"

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

namespace {

/// Of the reach, the share that centres are apart at least.
constexpr double kNearest = 0.45;

std::vector<PairPose> poses_of_unit_reach(int count) {
  RandomStream random(/*seed=*/6, "pair poses");
  std::vector<PairPose> poses(static_cast<std::size_t>(count));
  for (PairPose& pose : poses) {
    do {
      pose.b.position = random_in_unit_cube(random);
    } while (pose.b.position.norm() > 1.0 || pose.b.position.norm() < kNearest);
    pose.b.orientation = random_orientation(random);
  }
  return poses;
}

/// By halving.
double reach_of_share(const TriangleMesh& mesh, const std::vector<PairPose>& poses) {
  constexpr int kHalvings = 8;
  double near_m = 0.0;
  double far_m = 2.0;
  for (int halving = 0; halving < kHalvings; ++halving) {
    const double reach_m = 0.5 * (near_m + far_m);
    std::size_t crossing = 0;
    for (const PairPose& pose : poses) {
      const Pose here{reach_m * pose.b.position, pose.b.orientation};
      crossing += crosses_itself_at(mesh, here) ? 1U : 0U;
    }
    const bool enough =
        static_cast<double>(crossing) > kCrossingShare * static_cast<double>(poses.size());
    (enough ? near_m : far_m) = reach_m;
  }
  return 0.5 * (near_m + far_m);
}

}  // namespace

std::vector<PairPose> random_pair_poses(const TriangleMesh& mesh, int count) {
  std::vector<PairPose> poses = poses_of_unit_reach(count);
  const double reach_m = reach_of_share(mesh, poses);
  for (PairPose& pose : poses) {
    pose.b.position *= reach_m;
    pose.surfaces_cross = crosses_itself_at(mesh, pose.b);
  }
  return poses;
}

}  // namespace impetus
