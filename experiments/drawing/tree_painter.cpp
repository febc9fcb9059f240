// SPDX-License-Identifier: MIT
#include "experiments/drawing/tree_painter.hpp"

#include <epoxy/gl.h>

#include <algorithm>
#include <cmath>

namespace impetus::inline drawing {
namespace {

constexpr double kShownRadiusM = 0.05;  ///< suits the depth that all painters of this room share
constexpr double kDistanceInRadii = 7.0;
constexpr double kTreeRoom = 1.06;
constexpr double kTurnOfAPicture = 3.0;  ///< radians for a drag over the picture's height
constexpr double kZoomOfANotch = 1.15;
constexpr float kMeshOpacity = 0.5F;
constexpr std::array<float, 3> kMeshColour{0.86F, 0.84F, 0.80F};

/// Of the root volume and the mesh, for the middle of the picture.
Sphere bounds_of(const ShownTree& shown) {
  Eigen::AlignedBox3d box;
  for (const Vector3& vertex : shown.mesh.vertices) {
    box.extend(vertex);
  }
  const Vector3 centre = box.isEmpty() ? Vector3::Zero() : Vector3(box.center());
  double radius_m = 0.0;
  for (const Vector3& vertex : shown.mesh.vertices) {
    radius_m = std::max(radius_m, (vertex - centre).norm());
  }
  for (std::int32_t node = 0; node < std::min(shown.tree.node_count(), 100); ++node) {
    const Sphere bound = bounding_sphere(shown.tree.volume(node));
    radius_m = std::max(radius_m, (bound.centre - centre).norm() + bound.radius_m);
  }
  return {centre, radius_m > 0.0 ? radius_m : 1.0};
}

std::shared_ptr<const TriangleMesh> scaled(TriangleMesh mesh, const Vector3& centre, double scale) {
  for (Vector3& vertex : mesh.vertices) {
    vertex = scale * (vertex - centre);
  }
  return std::make_shared<const TriangleMesh>(std::move(mesh));
}

Viewer viewer_of(const Orbit& orbit, int width, int height) {
  const double least_m = 2.0 * kTreeRoom * kShownRadiusM / orbit.zoom;
  const double per_px = least_m / std::min(width, height);
  return viewer_at(
      {per_px * width, per_px * height, width, height, kDistanceInRadii * kShownRadiusM}, 0.0);
}

Quaternion turned(double angle_rad, const Vector3& axis) {
  return Quaternion(Eigen::AngleAxisd(angle_rad, axis));
}

bool same_volumes(const TreeLook& one, const TreeLook& other) {
  return one.level == other.level && one.colour == other.colour;
}

}  // namespace

Quaternion Orbit::initial_turn() {
  constexpr double kAsideRad = -0.6;
  constexpr double kFromAboveRad = 0.35;
  return turned(kFromAboveRad, Vector3::UnitX()) * turned(kAsideRad, Vector3::UnitY());
}

void Orbit::drag(double right, double up) {
  turn = turned(kTurnOfAPicture * right, Vector3::UnitY()) *
         turned(-kTurnOfAPicture * up, Vector3::UnitX()) * turn;
  turn.normalize();
}

void Orbit::notch(double notches) {
  zoom = std::clamp(zoom * std::pow(kZoomOfANotch, notches), 0.25, 40.0);
}

TreePainter::TreePainter(const ShownTree& shown) : shown_(shown) {
  const Sphere bounds = bounds_of(shown);
  scale_ = kShownRadiusM / bounds.radius_m;
  centre_ = bounds.centre;
  mesh_ = scaled(shown.mesh, centre_, scale_);
  choose({});
}

void TreePainter::choose(const TreeLook& look) {
  chosen_ = look;
  volumes_ = volumes_of(shown_.tree, look);
  for (ColouredVolume& volume : volumes_) {
    volume.shape.centre = scale_ * (volume.shape.centre - centre_);
    volume.shape.half_extents_m *= scale_;
    volume.shape.radius_m *= scale_;
  }
}

void TreePainter::paint(const TreeLook& look, const Orbit& orbit, const PixelArea& area,
                        float ground) {
  const Painted wanted{look, orbit, area.width, area.height, ground};
  target_.begin(area.width, area.height);
  if (wanted != painted_) {
    paint_here(look, orbit, area.width, area.height, ground);
    painted_ = wanted;
  }
  target_.end_onto(area);
}

void TreePainter::paint_here(const TreeLook& look, const Orbit& orbit, int width, int height,
                             float ground) {
  if (!same_volumes(look, chosen_)) {
    choose(look);
  }
  glViewport(0, 0, width, height);
  glClearColor(ground, ground, ground, 1.0F);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  Picture picture;
  picture.viewer = viewer_of(orbit, width, height);
  const Pose pose{Vector3::Zero(), orbit.turn};
  if (look.mesh) {
    picture.bodies = {{pose, {"", kShownRadiusM, kMeshColour, mesh_}}};
    mesh_painter_.paint(picture);
  }
  if (look.volumes) {
    std::vector<ColouredVolume> turned_volumes = volumes_;
    for (ColouredVolume& volume : turned_volumes) {
      volume.shape = posed(volume.shape, pose);
    }
    volume_painter_.paint(turned_volumes, picture.viewer, height, look.mesh ? kMeshOpacity : 1.0F);
  }
}

}  // namespace impetus::inline drawing
