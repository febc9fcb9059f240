// SPDX-License-Identifier: MIT
#include "experiments/drawing/tree_painter.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "experiments/drawing/gl.hpp"
#include "experiments/tables/number_text.hpp"

namespace impetus::inline drawing {
namespace {

using Colour = std::array<float, 3>;

constexpr Colour kNoGroupColour{0.62F, 0.62F, 0.62F};

/// Neighbouring levels differ in hue and in lightness.
constexpr std::array<Colour, 9> kLevelColours{{{0.31F, 0.47F, 0.65F},
                                               {0.95F, 0.56F, 0.17F},
                                               {0.35F, 0.63F, 0.31F},
                                               {0.88F, 0.34F, 0.35F},
                                               {0.14F, 0.56F, 0.58F},
                                               {0.69F, 0.48F, 0.63F},
                                               {0.93F, 0.79F, 0.28F},
                                               {0.61F, 0.46F, 0.37F},
                                               {0.73F, 0.69F, 0.67F}}};

int level_of(const VolumeTree& tree, std::int32_t node) {
  int level = 0;
  while (node >= tree.level_end(level)) {
    ++level;
  }
  return level;
}

/// From nearly empty (violet) over half (green) to solid (yellow).
Colour occupancy_colour(float occupancy) {
  constexpr std::array<Colour, 3> kStops{
      {{0.27F, 0.00F, 0.33F}, {0.13F, 0.57F, 0.55F}, {0.99F, 0.91F, 0.14F}}};
  const float place = 2.0F * std::clamp(occupancy, 0.0F, 1.0F);
  const std::size_t stop = place < 1.0F ? 0 : 1;
  const float share = place - static_cast<float>(stop);
  Colour colour{};
  for (std::size_t channel = 0; channel < 3; ++channel) {
    colour[channel] = (1.0F - share) * kStops[stop][channel] + share * kStops[stop + 1][channel];
  }
  return colour;
}

/// Hues a golden section apart: groups with numbers near each other look different.
Colour group_colour(std::int32_t group) {
  if (group == kNoGroup) {
    return kNoGroupColour;
  }
  constexpr double kGoldenSection = 0.6180339887498949;
  const double hue = 6.0 * std::fmod(group * kGoldenSection, 1.0);
  const double value = group % 2 == 0 ? 0.92 : 0.70;
  const auto channel = [&](double centre) {
    const double apart = std::abs(std::remainder(hue - centre, 6.0));
    return static_cast<float>(value * (0.25 + 0.75 * std::clamp(2.0 - apart, 0.0, 1.0)));
  };
  return {channel(0.0), channel(2.0), channel(4.0)};
}

/// A node's colour.
Colour node_colour(const VolumeTree& tree, std::int32_t node, TreeColour colour) {
  switch (colour) {
    case TreeColour::kOccupancy:
      return occupancy_colour(tree.surface(node).occupancy);
    case TreeColour::kGroup:
      return group_colour(tree.surface(node).group);
    case TreeColour::kLevel:
      break;
  }
  return kLevelColours[static_cast<std::size_t>(level_of(tree, node)) % kLevelColours.size()];
}

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

std::vector<LegendLine> legend_of(const ShownTree& shown, int level) {
  const double diagonal_m =
      shown.mesh.triangles.empty() ? 0.0 : bounds_of(shown.mesh).sides().norm();
  const double percent = 100.0 / std::max(diagonal_m, 1e-300);
  if (shown.quality.empty()) {
    return {{"nodes", std::to_string(shown.tree.standing_at(level).size())},
            {"protrusion, bound", printed("%.3g %%", percent * shown.tree.fit_error_m(level))}};
  }
  const LevelQuality& quality = shown.quality[static_cast<std::size_t>(level)];
  return {{"nodes", std::to_string(quality.nodes)},
          {"protrusion, worst", printed("%.3g %%", percent * quality.worst_protrusion_m)},
          {"protrusion, mean", printed("%.3g %%", percent * quality.mean_protrusion_m)},
          {"outside volume", printed("%.3g of the mesh", quality.outside_ratio)},
          {"largest node", printed("%.3g m", quality.largest_node_m)},
          {"memory", printed("%.1f kB", static_cast<double>(quality.bytes) / 1000.0)}};
}

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
  volumes_.clear();
  for (const std::int32_t node : shown_.tree.standing_at(look.level)) {
    RoundedBox shape = rounded_box(shown_.tree.volume(node));
    shape.centre = scale_ * (shape.centre - centre_);
    shape.half_extents_m *= scale_;
    shape.radius_m *= scale_;
    volumes_.push_back({shape, node_colour(shown_.tree, node, look.colour)});
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
