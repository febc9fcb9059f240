// SPDX-License-Identifier: MIT
#include "engine/trees/node_description.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "engine/numerics/spread_points.hpp"
#include "engine/shapes/surface_groups.hpp"
#include "engine/trees/fit_error.hpp"
#include "engine/trees/volume_tree.hpp"
#include "engine/volumes/rounded_box.hpp"

namespace impetus::inline trees {
namespace {

/// A point and how far about it nothing changes from solid to empty.
struct Known {
  Vector3 point;
  double clear_m;
  bool solid;
};

/// Whether a point is solid, by what is known where that says it, else by asking.
bool is_solid(const Vector3& point, const SurfaceDistance& solid, std::vector<Known>& known) {
  const auto found = std::find_if(known.begin(), known.end(), [&](const Known& about) {
    return (point - about.point).squaredNorm() < about.clear_m * about.clear_m;
  });
  if (found != known.end()) {
    return found->solid;
  }
  const double signed_m = solid.signed_distance_m(point);
  known.push_back({point, std::fabs(signed_m), signed_m < 0.0});
  return signed_m < 0.0;
}

}  // namespace

NodeDescription::NodeDescription(const TriangleMesh& solid)
    : distance_(solid), groups_(surface_groups(solid)) {}

NodeSurface NodeDescription::of(const Volume& volume, const SurfacePart& part) const {
  return of(volume, part, impetus::fit_error_m(volume, distance_));
}

NodeSurface NodeDescription::of(const Volume& volume, const SurfacePart& part,
                                double fit_error_m) const {
  NodeSurface surface;
  surface.fit_error_m = rounded_up(fit_error_m);
  surface.occupancy = static_cast<float>(occupancy_of(volume, distance_));
  surface.density_normal = density_normal_of(part).cast<float>();
  surface.group = group_of(part);
  return surface;
}

std::int32_t NodeDescription::group_of(const SurfacePart& part) const {
  std::map<std::int32_t, double> areas;
  for (const Facet& facet : part) {
    areas[groups_[facet.triangle]] += doubled_area_vector(facet).norm();
  }
  const auto largest = std::max_element(
      areas.begin(), areas.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  return largest == areas.end() ? kNoGroup : largest->first;
}

double occupancy_of(const Volume& volume, const SurfaceDistance& solid) {
  const Sphere bound = bounding_sphere(volume);
  const double signed_m = solid.signed_distance_m(bound.centre);
  if (std::fabs(signed_m) >= bound.radius_m) {
    return signed_m < 0.0 ? 1.0 : 0.0;
  }
  const RoundedBox form = rounded_box(volume);
  const Vector3 reach = form.reach_m();
  std::vector<Known> known{{bound.centre, std::fabs(signed_m), signed_m < 0.0}};
  int within = 0;
  int solid_points = 0;
  for (int index = 1; within < kOccupancyPoints; ++index) {
    const Vector3 share(spread_share(index, 2), spread_share(index, 3), spread_share(index, 5));
    const Vector3 local = (2.0 * share - Vector3::Ones()).cwiseProduct(reach);
    const Vector3 beyond = (local.cwiseAbs() - form.half_extents_m).cwiseMax(0.0);
    if (beyond.squaredNorm() <= form.radius_m * form.radius_m) {
      ++within;
      solid_points += is_solid(form.placed(local), solid, known) ? 1 : 0;
    }
  }
  return static_cast<double>(solid_points) / kOccupancyPoints;
}

Vector3 density_normal_of(const SurfacePart& part) {
  Vector3 doubled = Vector3::Zero();
  double doubled_m2 = 0.0;
  for (const Facet& facet : part) {
    const Vector3 facing = doubled_area_vector(facet);
    doubled += facing;
    doubled_m2 += facing.norm();
  }
  const double length = doubled.norm();
  const bool faces = length > 0.0 && length >= kLeastFacing * doubled_m2;
  return faces ? Vector3(doubled / length) : Vector3::Zero();
}

}  // namespace impetus::inline trees
