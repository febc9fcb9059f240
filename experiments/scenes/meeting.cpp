// SPDX-License-Identifier: MIT
#include "experiments/scenes/meeting.hpp"

#include <cmath>
#include <limits>
#include <vector>

namespace impetus {
namespace {

std::vector<Sphere> nodes_at(const VolumeTree& tree, const Quaternion& orientation, int level) {
  std::vector<Sphere> nodes;
  for (const std::int32_t index : tree.standing_at(level)) {
    const Sphere volume = bounding_sphere(tree.volume(index));
    nodes.push_back({orientation * volume.centre, volume.radius_m});
  }
  return nodes;
}

/// Distance along x between the centres of two nodes that touch; negative when they pass by.
double touching_distance(const Sphere& a, const Sphere& b) {
  const double aside_y = a.centre.y() - b.centre.y();
  const double aside_z = a.centre.z() - b.centre.z();
  const double reach = a.radius_m + b.radius_m;
  const double square = reach * reach - aside_y * aside_y - aside_z * aside_z;
  return square >= 0.0 ? std::sqrt(square) : -1.0;
}

}  // namespace

MeetingPlaces meeting_places(const VolumeTree& a, const Quaternion& orientation_a,
                             const VolumeTree& b, const Quaternion& orientation_b, int level) {
  MeetingPlaces places{-a.bounding_radius_m(), b.bounding_radius_m()};
  double furthest = -std::numeric_limits<double>::infinity();
  const std::vector<Sphere> nodes_b = nodes_at(b, orientation_b, level);
  for (const Sphere& node_a : nodes_at(a, orientation_a, level)) {
    for (const Sphere& node_b : nodes_b) {
      const double apart = touching_distance(node_a, node_b);
      const double separation = node_a.centre.x() - node_b.centre.x() + apart;
      if (apart < 0.0 || separation <= furthest) {
        continue;
      }
      furthest = separation;
      // The contact point divides the line of the node centres by their radii (eq. 3.8).
      const double reach = node_a.radius_m + node_b.radius_m;
      places.a_m = -(node_a.centre.x() + apart * (node_a.radius_m / reach));
      places.b_m = -node_b.centre.x() + apart * (node_b.radius_m / reach);
    }
  }
  return places;
}

}  // namespace impetus
