// SPDX-License-Identifier: MIT
#include "engine/trees/level_quality.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "engine/numerics/spread_points.hpp"
#include "engine/shapes/mass_properties.hpp"
#include "engine/shapes/surface_distance.hpp"
#include "engine/trees/coverage.hpp"
#include "engine/trees/fit_error.hpp"
#include "engine/trees/solid_grid.hpp"
#include "engine/volumes/rounded_box.hpp"
#include "engine/volumes/volume.hpp"

namespace impetus::inline trees {
namespace {

// How far the surface of a union of volumes lies from a solid on average.

constexpr double kPi = std::numbers::pi;

/// What counts as beyond a surface, as a share of the volume's size.
constexpr double kBeyond = 1e-9;

/// A point of a volume's surface.
struct SurfacePoint {
  Vector3 point;
  Vector3 outward;  ///< unit
};

double surface_area_m2(const RoundedBox& form) {
  const Vector3& half = form.half_extents_m;
  const double radius_m = form.radius_m;
  return 8.0 * (half.x() * half.y() + half.y() * half.z() + half.z() * half.x()) +
         4.0 * kPi * radius_m * (half.sum() + radius_m);
}

/// A point of the unit disc, evenly spread; the index moves on past what falls beside it.
std::array<double, 2> disc_point(int& index) {
  while (true) {
    ++index;
    const double x = 2.0 * spread_share(index, 2) - 1.0;
    const double y = 2.0 * spread_share(index, 3) - 1.0;
    const double squared = x * x + y * y;
    if (squared < 1.0 && squared > 0.0) {
      return {x, y};
    }
  }
}

/// A unit vector, evenly spread over the sphere. (Marsaglia 1972)
Vector3 sphere_point(int& index) {
  const auto [x, y] = disc_point(index);
  const double squared = x * x + y * y;
  const double scale = 2.0 * std::sqrt(1.0 - squared);
  return {scale * x, scale * y, 1.0 - 2.0 * squared};
}

/// One of a box's faces, edges or corners, rounded: where `outward` has no part along an axis, the
/// point lies anywhere along it, else at the end that it points to.
SurfacePoint point_towards(const RoundedBox& form, const Vector3& outward, double s, double t) {
  Vector3 core;
  double share = s;
  for (int axis = 0; axis < 3; ++axis) {
    const double half = form.half_extents_m[axis];
    if (outward[axis] != 0.0) {
      core[axis] = std::copysign(half, outward[axis]);
    } else {
      core[axis] = (2.0 * share - 1.0) * half;
      share = t;
    }
  }
  return {form.placed(core + form.radius_m * outward), form.axes * outward};
}

/// The next of a fixed sequence of points spread evenly over the surface.
SurfacePoint next_point(const RoundedBox& form, int& index) {
  const Vector3& half = form.half_extents_m;
  const double radius_m = form.radius_m;
  ++index;
  double share = spread_share(index, 11) * surface_area_m2(form);
  const double s = spread_share(index, 5);
  const double t = spread_share(index, 7);
  for (int axis = 0; axis < 3; ++axis) {
    const double face_m2 = 4.0 * half[(axis + 1) % 3] * half[(axis + 2) % 3];
    for (const double sign : {-1.0, 1.0}) {
      if (share < face_m2) {
        return point_towards(form, sign * Vector3::Unit(axis), s, t);
      }
      share -= face_m2;
    }
  }
  for (int axis = 0; axis < 3; ++axis) {
    const double edges_m2 = 4.0 * kPi * radius_m * half[axis];
    if (share < edges_m2) {
      const auto [x, y] = disc_point(index);
      Vector3 outward = Vector3::Zero();
      outward[(axis + 1) % 3] = x;
      outward[(axis + 2) % 3] = y;
      return point_towards(form, outward.normalized(), s, t);
    }
    share -= edges_m2;
  }
  return point_towards(form, sphere_point(index), s, t);
}

/// Whether a point of volume `own`'s surface lies within the union of the others. Of surfaces that
/// coincide the first counts.
bool within_another(const std::vector<Volume>& volumes, std::size_t own,
                    const std::vector<std::size_t>& others, const SurfacePoint& at,
                    double beyond_m) {
  return std::any_of(others.begin(), others.end(), [&](std::size_t other) {
    return holds(volumes[other], at.point + beyond_m * at.outward) ||
           (other < own && holds(volumes[other], at.point));
  });
}

std::vector<std::size_t> near(const std::vector<Sphere>& bounds, std::size_t own) {
  std::vector<std::size_t> found;
  for (std::size_t other = 0; other < bounds.size(); ++other) {
    if (other != own && overlap(bounds[own], bounds[other])) {
      found.push_back(other);
    }
  }
  return found;
}

/// Distance to the solid (metres; 0 inside) averaged over the surface of the union of `volumes`, by
/// about `samples` points spread evenly over the volumes' surfaces; those within another volume are
/// not of the union's.
double mean_protrusion_m(const std::vector<Volume>& volumes, const SurfaceDistance& solid,
                         int samples) {
  double total_m2 = 0.0;
  std::vector<Sphere> bounds;
  for (const Volume& volume : volumes) {
    total_m2 += surface_area_m2(rounded_box(volume));
    bounds.push_back(bounding_sphere(volume));
  }
  double sum_m3 = 0.0;
  double area_m2 = 0.0;
  int index = 0;
  for (std::size_t own = 0; own < volumes.size(); ++own) {
    const RoundedBox form = rounded_box(volumes[own]);
    const double own_m2 = surface_area_m2(form);
    const int count = 1 + static_cast<int>(samples * own_m2 / total_m2);
    const std::vector<std::size_t> others = near(bounds, own);
    for (int sample = 0; sample < count; ++sample) {
      const SurfacePoint at = next_point(form, index);
      if (!within_another(volumes, own, others, at, kBeyond * bounds[own].radius_m)) {
        area_m2 += own_m2 / count;
        sum_m3 += own_m2 / count * std::max(0.0, solid.signed_distance_m(at.point));
      }
    }
  }
  return area_m2 > 0.0 ? sum_m3 / area_m2 : 0.0;
}

constexpr int kDivisions = 128;
constexpr int kSurfaceSamples = 6'000;

/// What one node takes of the arrays that hold volumes. A sphere has a place in a block, and one of
/// several kinds in its kind's array.
std::size_t volume_bytes(const VolumeTree& tree, std::int32_t node, bool several_kinds) {
  if (tree.volumes().are_voxels()) {
    return sizeof(std::uint32_t);
  }
  const bool has_place = several_kinds || tree.blocks().count() > 0;
  return std::visit([](const auto& kind) { return sizeof(kind); }, tree.volume(node)) +
         (has_place ? sizeof(std::uint32_t) : 0);
}

bool has_several_kinds(const VolumeTree& tree) {
  for (std::int32_t node = 1; node < tree.node_count(); ++node) {
    if (tree.volume(node).index() != tree.volume(0).index()) {
      return true;
    }
  }
  return false;
}

std::size_t bytes_of(const VolumeTree& tree, int level) {
  const bool several_kinds = has_several_kinds(tree);
  std::size_t bytes = 0;
  for (std::int32_t node = tree.level_begin(level); node < tree.level_end(level); ++node) {
    bytes += volume_bytes(tree, node, several_kinds) + sizeof(NodeLinks) + sizeof(NodeSurface);
  }
  return bytes;
}

std::vector<Volume> volumes_at(const VolumeTree& tree, int level) {
  std::vector<Volume> volumes;
  for (const std::int32_t node : tree.standing_at(level)) {
    volumes.push_back(tree.volume(node));
  }
  return volumes;
}

LevelQuality quality_of(const TriangleMesh& solid, const SurfaceDistance& distance,
                        const VolumeTree& tree, int level) {
  const std::vector<Volume> volumes = volumes_at(tree, level);
  LevelQuality quality;
  quality.nodes = static_cast<std::int32_t>(volumes.size());
  for (const Volume& volume : volumes) {
    quality.worst_protrusion_m = std::max(
        quality.worst_protrusion_m, fit_error_m(volume, distance, quality.worst_protrusion_m));
    quality.largest_node_m =
        std::max(quality.largest_node_m, 2.0 * bounding_sphere(volume).radius_m);
  }
  quality.mean_protrusion_m = mean_protrusion_m(volumes, distance, kSurfaceSamples);
  quality.outside_ratio = outside_volume_m3(solid, volumes, kDivisions) /
                          solid_of(solid, /*density_kg_m3=*/1.0).volume_m3;
  quality.bytes = bytes_of(tree, level);
  quality.uncovered_area_m2 = uncovered_area_m2(solid, tree, level);
  return quality;
}

}  // namespace

std::vector<LevelQuality> measure_levels(const TriangleMesh& solid, const VolumeTree& tree,
                                         const Progress& progress) {
  const SurfaceDistance distance(solid);
  std::vector<LevelQuality> levels;
  for (int level = 0; level < tree.level_count(); ++level) {
    if (progress) {
      progress(static_cast<double>(level) / tree.level_count());
    }
    levels.push_back(quality_of(solid, distance, tree, level));
  }
  if (progress) {
    progress(1.0);
  }
  return levels;
}

}  // namespace impetus::inline trees
