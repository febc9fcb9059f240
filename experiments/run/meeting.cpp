// SPDX-License-Identifier: MIT
#include "experiments/run/meeting.hpp"

#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "engine/volumes/volume.hpp"

namespace impetus::inline run {
namespace {

/// A node turned about the centre of mass, and the sphere round it.
struct Node {
  Volume volume;
  Sphere bound;
};

std::vector<Node> nodes_at(const VolumeTree& tree, const Quaternion& orientation, int level,
                           const Vector3& aside = Vector3::Zero()) {
  std::vector<Node> nodes;
  for (const std::int32_t index : tree.standing_at(level)) {
    const Volume volume = tree.volume(index);
    const Sphere bound = bounding_sphere(volume);
    nodes.push_back({placed(volume, {aside, orientation}),
                     {orientation * bound.centre + aside, bound.radius_m}});
  }
  return nodes;
}

bool is_sphere(const Node& node) { return std::holds_alternative<Sphere>(node.volume); }

/// Distance along x between the centres of two nodes that touch; negative when they pass by.
double touching_distance(const Sphere& a, const Sphere& b) {
  const double aside_y = a.centre.y() - b.centre.y();
  const double aside_z = a.centre.z() - b.centre.z();
  const double reach = a.radius_m + b.radius_m;
  const double square = reach * reach - aside_y * aside_y - aside_z * aside_z;
  return square >= 0.0 ? std::sqrt(square) : -1.0;
}

/// The contact point divides the line of the node centres by their radii (eq. 3.8).
MeetingPlaces places_of_spheres(const Sphere& a, const Sphere& b, double apart_m) {
  const double reach_m = a.radius_m + b.radius_m;
  return {-(a.centre.x() + apart_m * (a.radius_m / reach_m)),
          -b.centre.x() + apart_m * (b.radius_m / reach_m)};
}

/// A cube touches with its own faces; as a node its contact is that of a sphere.
Volume with_own_faces(const Volume& volume) {
  const auto* cube = std::get_if<Cube>(&volume);
  return cube != nullptr
             ? Volume(Box{cube->centre, Vector3::Constant(cube->half_edge_m), cube->orientation})
             : volume;
}

/// Moves b towards a along −x from `separation_m`, where they are apart, until they touch; none
/// when they pass by. The distance of convex volumes is convex in the way, so Newton's steps never
/// go too far.
std::optional<double> touching_separation(const Volume& a, const Volume& b, double separation_m,
                                          TouchPoint& contact) {
  constexpr int kMostSteps = 200;
  constexpr double kTouching = 1e-12;
  const double size_m = bounding_sphere(a).radius_m + bounding_sphere(b).radius_m;
  const double least_m = separation_m - 2.0 * size_m;
  for (int step = 0; step < kMostSteps && separation_m >= least_m; ++step) {
    contact =
        touch(a, placed(b, {{separation_m, 0.0, 0.0}, Quaternion::Identity()}), -Vector3::UnitX());
    const double gap_m = -contact.depth_m;
    if (gap_m <= kTouching * size_m) {
      return separation_m;
    }
    const double slope = -contact.normal.x();
    if (!(slope > 0.0)) {
      return std::nullopt;
    }
    separation_m -= gap_m / slope;
  }
  return std::nullopt;
}

/// The places at which the first of their nodes touch; none when all pass by.
std::optional<MeetingPlaces> first_touch(const std::vector<Node>& nodes_a,
                                         const std::vector<Node>& nodes_b) {
  std::optional<MeetingPlaces> places;
  double furthest = -std::numeric_limits<double>::infinity();
  for (const Node& node_a : nodes_a) {
    for (const Node& node_b : nodes_b) {
      const double apart = touching_distance(node_a.bound, node_b.bound);
      const double separation = node_a.bound.centre.x() - node_b.bound.centre.x() + apart;
      if (apart < 0.0 || separation <= furthest) {
        continue;
      }
      if (is_sphere(node_a) && is_sphere(node_b)) {
        furthest = separation;
        places = places_of_spheres(node_a.bound, node_b.bound, apart);
        continue;
      }
      TouchPoint contact;
      const auto touching = touching_separation(with_own_faces(node_a.volume),
                                                with_own_faces(node_b.volume), separation, contact);
      if (touching && *touching > furthest) {
        furthest = *touching;
        places = {-contact.point.x(), *touching - contact.point.x()};
      }
    }
  }
  return places;
}

}  // namespace

MeetingPlaces meeting_places(const VolumeTree& a, const Quaternion& orientation_a,
                             const VolumeTree& b, const Quaternion& orientation_b, int level,
                             const Vector3& aside_b) {
  return first_touch(nodes_at(a, orientation_a, level), nodes_at(b, orientation_b, level, aside_b))
      .value_or(MeetingPlaces{-a.bounding_radius_m(), b.bounding_radius_m()});
}

bool can_meet(const VolumeTree& a, const Quaternion& orientation_a, const VolumeTree& b,
              const Quaternion& orientation_b, int level, const Vector3& aside_b) {
  return first_touch(nodes_at(a, orientation_a, level), nodes_at(b, orientation_b, level, aside_b))
      .has_value();
}

}  // namespace impetus::inline run
