// SPDX-License-Identifier: MIT
#include "experiments/session/collision_truth.hpp"

#include <algorithm>
#include <array>
#include <initializer_list>

#include "engine/shapes/mesh_distance.hpp"

namespace impetus {
namespace {

constexpr int kSampleRays = 64;

/// Two spheres need no mesh: the closest points lie on the line of their centres.
ClosestPoints sphere_distance(const DrawnBody& a, const Pose& pose_a, const DrawnBody& b,
                              const Pose& pose_b) {
  const Vector3 a_to_b = pose_b.position - pose_a.position;
  const double distance = a_to_b.norm();
  const Vector3 along = distance > 0.0 ? Vector3(a_to_b / distance) : Vector3::UnitX();
  const double gap_m = std::max(0.0, distance - a.radius_m - b.radius_m);
  const Vector3 on_a = pose_a.position + a.radius_m * along;
  return {gap_m, on_a, on_a + gap_m * along};
}

/// Whether the segment from `eye` to `target` passes through a face of the body before its end.
bool covers(const DrawnBody& body, const Pose& pose, const Vector3& eye, const Vector3& target) {
  const Vector3 ray = target - eye;
  // Ends short of the target: the faces that the gap itself ends on do not hide it.
  constexpr double kNearEnd = 1.0 - 1e-6;
  if (!body.mesh) {
    const double along = (pose.position - eye).dot(ray) / ray.squaredNorm();
    const Vector3 nearest = eye + std::clamp(along, 0.0, kNearEnd) * ray;
    return (nearest - pose.position).norm() < body.radius_m * kNearEnd;
  }
  // Möller and Trumbore 1997.
  return std::any_of(body.mesh->triangles.begin(), body.mesh->triangles.end(),
                     [&](const auto& triangle) {
                       const auto& vertices = body.mesh->vertices;
                       const Vector3 a = pose.transform(vertices[triangle[0]]);
                       const Vector3 ab = pose.transform(vertices[triangle[1]]) - a;
                       const Vector3 ac = pose.transform(vertices[triangle[2]]) - a;
                       const Vector3 across = ray.cross(ac);
                       const double determinant = ab.dot(across);
                       if (determinant == 0.0) {
                         return false;
                       }
                       const Vector3 from_a = eye - a;
                       const double u = from_a.dot(across) / determinant;
                       const Vector3 q = from_a.cross(ab);
                       const double v = ray.dot(q) / determinant;
                       const double t = ac.dot(q) / determinant;
                       return u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t > 0.0 && t < kNearEnd;
                     });
}

/// The point of the screen's plane that a point of the world projects to (pixels, from centre).
Eigen::Vector2d projected_px(const Viewer& viewer, const Vector3& point) {
  const ScreenPoint at = projected(viewer, point).value_or(ScreenPoint{});
  return {at.x_m * viewer.screen.width_px / viewer.screen.width_m,
          at.y_m * viewer.screen.height_px / viewer.screen.height_m};
}

/// A body as it is drawn, which may cover a gap.
struct Cover {
  const DrawnBody& look;
  const Pose& pose;
};

CollisionTruth truth_of(const ClosestPoints& closest, std::initializer_list<Cover> covers_of_it,
                        const Viewer& viewer) {
  CollisionTruth truth;
  truth.gap_m = closest.distance_m;
  truth.gap_arcmin = 60.0 * visual_angle_deg(viewer, closest.on_a, closest.on_b);
  truth.gap_px = (projected_px(viewer, closest.on_a) - projected_px(viewer, closest.on_b)).norm();
  if (truth.gap_m <= 0.0) {
    return truth;
  }
  int hidden = 0;
  for (int ray = 0; ray < kSampleRays; ++ray) {
    const double share = (ray + 0.5) / kSampleRays;
    const Vector3 target = closest.on_a + share * (closest.on_b - closest.on_a);
    hidden += std::any_of(covers_of_it.begin(), covers_of_it.end(), [&](const Cover& cover) {
      return covers(cover.look, cover.pose, viewer.eye, target);
    });
  }
  truth.hidden_share = static_cast<double>(hidden) / kSampleRays;
  return truth;
}

/// The point of the drawn body that lies farthest along `outward` (unit).
Vector3 farthest_along(const Vector3& outward, const DrawnBody& look, const Pose& pose) {
  if (!look.mesh) {
    return pose.position + look.radius_m * outward;
  }
  const auto& vertices = look.mesh->vertices;
  const Vector3 outward_B = pose.orientation.conjugate() * outward;
  const auto farthest = std::max_element(
      vertices.begin(), vertices.end(),
      [&](const Vector3& p, const Vector3& q) { return outward_B.dot(p) < outward_B.dot(q); });
  return pose.transform(*farthest);
}

}  // namespace

CollisionTruth measure_truth(const DrawnBody& a, const Pose& pose_a, const DrawnBody& b,
                             const Pose& pose_b, const Viewer& viewer) {
  const bool meshes = a.mesh && b.mesh;
  const ClosestPoints closest = meshes ? mesh_distance(*a.mesh, pose_a, *b.mesh, pose_b)
                                       : sphere_distance(a, pose_a, b, pose_b);
  return truth_of(closest, {{a, pose_a}, {b, pose_b}}, viewer);
}

CollisionTruth measure_wall_truth(const DrawnBody& look, const Pose& pose, const Enclosure& walls,
                                  int wall, const Viewer& viewer) {
  const Vector3 outward = -inward_normal(walls, wall);
  const Vector3 on_body = farthest_along(outward, look, pose);
  const double gap_m = std::max(0.0, -reach_beyond(walls, wall, Sphere{on_body, 0.0}));
  return truth_of({gap_m, on_body, on_body + gap_m * outward}, {{look, pose}}, viewer);
}

}  // namespace impetus
