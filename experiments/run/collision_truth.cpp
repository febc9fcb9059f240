// SPDX-License-Identifier: MIT
#include "experiments/run/collision_truth.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <utility>
#include <vector>

#include "engine/numerics/elementary_functions.hpp"
#include "engine/shapes/mesh_distance.hpp"

namespace impetus::inline run {
namespace {

/// Two balls need no mesh: the closest points lie on the line of their centres.
ClosestPoints distance_of_balls(const DrawnBody& a, const Pose& pose_a, const DrawnBody& b,
                                const Pose& pose_b) {
  const Vector3 a_to_b = pose_b.position - pose_a.position;
  const double distance = a_to_b.norm();
  const Vector3 along = distance > 0.0 ? Vector3(a_to_b / distance) : Vector3::UnitX();
  const double gap_m = std::max(0.0, distance - a.radius_m - b.radius_m);
  const Vector3 on_a = pose_a.position + a.radius_m * along;
  return {gap_m, on_a, on_a + gap_m * along};
}

}  // namespace

ClosestPoints closest_surfaces(const DrawnBody& a, const Pose& pose_a, const DrawnBody& b,
                               const Pose& pose_b) {
  if (a.mesh && b.mesh) {
    return mesh_distance(*a.mesh, pose_a, *b.mesh, pose_b);
  }
  if (a.mesh) {
    return ball_distance(*a.mesh, pose_a, pose_b.position, b.radius_m);
  }
  if (b.mesh) {
    ClosestPoints closest = ball_distance(*b.mesh, pose_b, pose_a.position, a.radius_m);
    std::swap(closest.on_a, closest.on_b);
    return closest;
  }
  return distance_of_balls(a, pose_a, b, pose_b);
}

namespace {

constexpr int kSampleRays = 64;

/// A triangle in world, as one corner and the edges from it.
struct Face {
  Vector3 a;
  Vector3 ab;
  Vector3 ac;
};

/// Ends short of the target: the faces that the gap itself ends on do not hide it.
constexpr double kNearEnd = 1.0 - 1e-6;

/// Whether the way from `eye` along `ray` passes through the face before its end. (Möller and
/// Trumbore 1997)
bool crosses(const Face& face, const Vector3& eye, const Vector3& ray) {
  const Vector3 across = ray.cross(face.ac);
  const double determinant = face.ab.dot(across);
  if (determinant == 0.0) {
    return false;
  }
  const Vector3 from_a = eye - face.a;
  const double u = from_a.dot(across) / determinant;
  const Vector3 q = from_a.cross(face.ab);
  const double v = ray.dot(q) / determinant;
  const double t = face.ac.dot(q) / determinant;
  return u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t > 0.0 && t < kNearEnd;
}

/// A drawn body as the rays from the eye to a gap meet it: a ball, or the faces that reach the
/// plane in which all these rays lie.
///
///   eye ·<:::::: p           faces on one side of the plane through eye, p and q are met by none,
///          ::::: q           and most are
class Cover {
 public:
  Cover(const DrawnBody& body, const Pose& pose, const Vector3& eye, const ClosestPoints& gap)
      : body_(body), centre_(pose.position), eye_(eye) {
    if (!body.mesh) {
      return;
    }
    const Vector3 normal = plane_of(gap.on_a - eye, gap.on_b - eye);
    std::vector<Vector3> corners;
    std::vector<int> sides;
    for (const Vector3& vertex : body.mesh->vertices) {
      corners.push_back(pose.transform(vertex));
      sides.push_back(side_of(normal, corners.back() - eye));
    }
    for (const auto& [a, b, c] : body.mesh->triangles) {
      const bool aside = sides[a] != 0 && sides[a] == sides[b] && sides[a] == sides[c];
      if (!aside) {
        faces_.push_back({corners[a], corners[b] - corners[a], corners[c] - corners[a]});
      }
    }
  }

  /// Whether the body stands between the eye and `target`, a point of the gap.
  [[nodiscard]] bool hides(const Vector3& target) const {
    const Vector3 ray = target - eye_;
    if (!body_.mesh) {
      const double along = (centre_ - eye_).dot(ray) / ray.squaredNorm();
      const Vector3 nearest = eye_ + std::clamp(along, 0.0, kNearEnd) * ray;
      return (nearest - centre_).norm() < body_.radius_m * kNearEnd;
    }
    return std::any_of(faces_.begin(), faces_.end(),
                       [&](const Face& face) { return crosses(face, eye_, ray); });
  }

 private:
  /// Across both ways to the gap; zero when they are too nearly one for a plane to be known, and
  /// then no face lies aside.
  static Vector3 plane_of(const Vector3& to_p, const Vector3& to_q) {
    constexpr double kNearlyOne = 1e-8;
    const Vector3 normal = to_p.cross(to_q);
    const bool known = normal.norm() > kNearlyOne * to_p.norm() * to_q.norm();
    return known ? normal : Vector3(Vector3::Zero());
  }

  /// 1 or −1 beside the plane; 0 in it, or too near for its side to be known after rounding.
  static int side_of(const Vector3& normal, const Vector3& from_eye) {
    constexpr double kUnsure = 1e-6;
    const double along = normal.dot(from_eye);
    const double unsure = kUnsure * normal.norm() * from_eye.norm();
    return along > unsure ? 1 : along < -unsure ? -1 : 0;
  }

  const DrawnBody& body_;
  Vector3 centre_;
  Vector3 eye_;
  std::vector<Face> faces_;
};

/// The point of the screen's plane that a point of the world projects to (pixels, from centre).
Eigen::Vector2d projected_px(const Viewer& viewer, const Vector3& point) {
  const ScreenPoint at = projected(viewer, point).value_or(ScreenPoint{});
  return {at.x_m * viewer.screen.width_px / viewer.screen.width_m,
          at.y_m * viewer.screen.height_px / viewer.screen.height_m};
}

/// A body as it is drawn.
struct PlacedLook {
  const DrawnBody& look;
  const Pose& pose;
};

CollisionTruth truth_of(const ClosestPoints& closest, std::initializer_list<PlacedLook> bodies,
                        const Viewer& viewer) {
  CollisionTruth truth;
  truth.gap_m = closest.distance_m;
  truth.gap_arcmin = kArcminPerDegree * visual_angle_deg(viewer, closest.on_a, closest.on_b);
  truth.gap_px = (projected_px(viewer, closest.on_a) - projected_px(viewer, closest.on_b)).norm();
  if (truth.gap_m <= 0.0) {
    return truth;
  }
  std::vector<Cover> covers;
  for (const PlacedLook& body : bodies) {
    covers.emplace_back(body.look, body.pose, viewer.eye, closest);
  }
  int hidden = 0;
  for (int ray = 0; ray < kSampleRays; ++ray) {
    const double share = (ray + 0.5) / kSampleRays;
    const Vector3 target = closest.on_a + share * (closest.on_b - closest.on_a);
    hidden += std::any_of(covers.begin(), covers.end(),
                          [&](const Cover& cover) { return cover.hides(target); });
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

ClosestPoints wall_gap(const DrawnBody& look, const Pose& pose, const Enclosure& walls, int wall) {
  const Vector3 outward = -inward_normal(walls, wall);
  const Vector3 on_body = farthest_along(outward, look, pose);
  const double gap_m = std::max(0.0, -reach_beyond(walls, wall, Sphere{on_body, 0.0}));
  return {gap_m, on_body, on_body + gap_m * outward};
}

/// The corner of a placed mesh nearest to `point`, in world.
Vector3 nearest_corner(const TriangleMesh& mesh, const Pose& pose, const Vector3& point) {
  const Vector3 point_B = pose.orientation.conjugate() * (point - pose.position);
  const auto nearest = std::min_element(
      mesh.vertices.begin(), mesh.vertices.end(), [&](const Vector3& p, const Vector3& q) {
        return (p - point_B).squaredNorm() < (q - point_B).squaredNorm();
      });
  return pose.transform(*nearest);
}

/// Of the drawn body about its origin.
double reach_m(const DrawnBody& body) {
  if (!body.mesh) {
    return body.radius_m;
  }
  double most_m2 = 0.0;
  for (const Vector3& vertex : body.mesh->vertices) {
    most_m2 = std::max(most_m2, vertex.squaredNorm());
  }
  return std::sqrt(most_m2);
}

/// No less than the gap: between corners, each the nearest to the one before.
double most_gap_m(const DrawnBody& a, const Pose& pose_a, const DrawnBody& b, const Pose& pose_b) {
  if (!a.mesh || !b.mesh) {
    return closest_surfaces(a, pose_a, b, pose_b).distance_m;
  }
  const Vector3 first = nearest_corner(*b.mesh, pose_b, pose_a.position);
  const Vector3 on_a = nearest_corner(*a.mesh, pose_a, first);
  return (nearest_corner(*b.mesh, pose_b, on_a) - on_a).norm();
}

}  // namespace

double most_gap_arcmin(const DrawnBody& a, const Pose& pose_a, const DrawnBody& b,
                       const Pose& pose_b, const Viewer& viewer) {
  constexpr double kBeyondRounding = 1.0 + 1e-6;
  constexpr double kHalfTurn_deg = 180.0;
  const double gap_m = most_gap_m(a, pose_a, b, pose_b);
  const double nearest_m = std::min((pose_a.position - viewer.eye).norm() - reach_m(a),
                                    (pose_b.position - viewer.eye).norm() - reach_m(b));
  // Two points no nearer than this and so far apart are widest apart when both are as near as that.
  const double half_sine = gap_m / (2.0 * nearest_m);
  if (nearest_m <= 0.0 || half_sine >= 1.0) {
    return kArcminPerDegree * kHalfTurn_deg;
  }
  const double half_rad = atan2_rad(half_sine, std::sqrt(1.0 - half_sine * half_sine));
  return kArcminPerDegree * degrees(2.0 * half_rad) * kBeyondRounding;
}

double wall_gap_arcmin(const DrawnBody& look, const Pose& pose, const Enclosure& walls, int wall,
                       const Viewer& viewer) {
  const ClosestPoints gap = wall_gap(look, pose, walls, wall);
  return kArcminPerDegree * visual_angle_deg(viewer, gap.on_a, gap.on_b);
}

CollisionTruth measure_truth(const DrawnBody& a, const Pose& pose_a, const DrawnBody& b,
                             const Pose& pose_b, const Viewer& viewer) {
  const ClosestPoints closest = closest_surfaces(a, pose_a, b, pose_b);
  return truth_of(closest, {{a, pose_a}, {b, pose_b}}, viewer);
}

CollisionTruth measure_wall_truth(const DrawnBody& look, const Pose& pose, const Enclosure& walls,
                                  int wall, const Viewer& viewer) {
  return truth_of(wall_gap(look, pose, walls, wall), {{look, pose}}, viewer);
}

CollisionTruth measure_truth(const StagedScene& scene, const World& world, BodyPair bodies,
                             std::int64_t step) {
  const auto a = static_cast<std::size_t>(bodies.a);
  const Viewer viewer = scene.viewer_at_time(static_cast<double>(step) / scene.step_hz);
  const Pose& pose_a = world.states()[a].pose;
  if (is_wall(bodies.b)) {
    return measure_wall_truth(scene.looks[a], pose_a, *world.settings().enclosure,
                              kEnclosure - bodies.b, viewer);
  }
  const auto b = static_cast<std::size_t>(bodies.b);
  return measure_truth(scene.looks[a], pose_a, scene.looks[b], world.states()[b].pose, viewer);
}

}  // namespace impetus::inline run
