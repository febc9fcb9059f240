// Trees to be stored, of every kind of volume.
// SPDX-License-Identifier: MIT
#pragma once

#include <exception>
#include <functional>
#include <string>
#include <vector>

#include "engine/numerics/random_stream.hpp"
#include "engine/shapes/solids/block_meshes.hpp"
#include "experiments/models/tree_file.hpp"
#include "tests/experiments/sentence_of.hpp"

namespace impetus {

inline Vector3 random_vector(RandomStream& random) {
  const double x = random.uniform();
  const double y = random.uniform();
  return {2.0 * x - 1.0, 2.0 * y - 1.0, 2.0 * random.uniform() - 1.0};
}

inline Quaternion random_rotation(RandomStream& random) {
  const Vector3 axis = random_vector(random);
  return Quaternion(1.0, axis.x(), axis.y(), axis.z()).normalized();
}

/// `kind`: the row in Volume.
inline Volume random_volume(RandomStream& random, std::size_t kind) {
  const Vector3 centre = random_vector(random);
  const Vector3 one = random_vector(random);
  const Vector3 other = one.cross(random_vector(random));
  const double size_m = random.uniform();
  switch (kind) {
    case 0:
      return Sphere{centre, size_m};
    case 1:
      return LineSwept{centre, one, size_m};
    case 2:
      return RectangleSwept{centre, one, other, size_m};
    case 3:
      return Box{centre, one.cwiseAbs(), random_rotation(random)};
    default:
      return Cube{centre, size_m, random_rotation(random)};
  }
}

inline NodeSurface random_surface(RandomStream& random) {
  NodeSurface surface;
  surface.occupancy = static_cast<float>(random.uniform());
  surface.group = static_cast<std::int32_t>(10.0 * random.uniform()) - 1;
  surface.density_normal = random_vector(random).normalized().cast<float>();
  surface.fit_error_m = static_cast<float>(random.uniform());
  return surface;
}

/// A root, three children, and two children of the second of them.
inline std::vector<NodeLinks> small_links() {
  return {{1, 3}, {0, 0}, {4, 2}, {0, 0}, {0, 0}, {0, 0}};
}
inline std::vector<std::int32_t> small_levels() { return {0, 1, 4}; }

inline StoredTree stored(NodeVolumes volumes, RandomStream& random) {
  std::vector<NodeSurface> surfaces;
  for (std::size_t node = 0; node < small_links().size(); ++node) {
    surfaces.push_back(random_surface(random));
  }
  VolumeTree tree(std::move(volumes), small_links(), surfaces, small_levels());
  return {"box.obj", {TreeKind::kHeterogeneous, 2, 3}, box_mesh({1.0, 0.1, 0.3}), tree};
}

inline StoredTree stored_of_one_kind(RandomStream& random, std::size_t kind) {
  std::vector<Volume> volumes;
  for (std::size_t node = 0; node < small_links().size(); ++node) {
    volumes.push_back(random_volume(random, kind));
  }
  return stored(NodeVolumes(volumes), random);
}

inline StoredTree stored_of_all_kinds(RandomStream& random) {
  std::vector<Volume> volumes;
  for (std::size_t node = 0; node < small_links().size(); ++node) {
    volumes.push_back(random_volume(random, node % std::variant_size_v<Volume>));
  }
  return stored(NodeVolumes(volumes), random);
}

inline StoredTree stored_voxels(RandomStream& random) {
  const VoxelGrid grid{{-0.1, 1.0 / 3.0, -0.7}, 0.9, 2};
  return stored(NodeVolumes(grid, {0, 1, 2, 7, 4, 63}, small_levels()), random);
}

/// One of each.
inline std::vector<StoredTree> all_stored(RandomStream& random) {
  std::vector<StoredTree> all;
  for (std::size_t kind = 0; kind < std::variant_size_v<Volume>; ++kind) {
    all.push_back(stored_of_one_kind(random, kind));
  }
  all.push_back(stored_of_all_kinds(random));
  all.push_back(stored_voxels(random));
  return all;
}

}  // namespace impetus
