// SPDX-License-Identifier: MIT
#include "experiments/scenes/shape_library.hpp"

#include <algorithm>
#include <atomic>
#include <optional>
#include <utility>

#include "engine/shapes/solids/ball_meshes.hpp"
#include "engine/shapes/solids/block_meshes.hpp"
#include "engine/shapes/solids/creature_mesh.hpp"
#include "engine/shapes/solids/prism_meshes.hpp"
#include "engine/shapes/solids/ring_meshes.hpp"
#include "engine/trees/builders/build_tree.hpp"
#include "engine/trees/builders/swept_tree.hpp"
#include "experiments/scenes/coarser_meshes.hpp"
#include "experiments/scenes/scene_meshes.hpp"

namespace impetus::inline scenes {
namespace {

BodyShape sphere_shape(double radius_m) {
  const VolumeTree tree = single_node_tree(Sphere{Vector3::Zero(), radius_m});
  return {nullptr, std::make_shared<const VolumeTree>(tree), solid_sphere(radius_m, 1.0), radius_m};
}

/// Drawn flat, and otherwise the sphere: in a plane across z, exactly the disc.
BodyShape disc_shape(double radius_m) {
  BodyShape shape = sphere_shape(radius_m);
  shape.mesh = std::make_shared<const TriangleMesh>(disc_mesh(radius_m));
  return shape;
}

/// Of a mesh about its centre of mass.
BodyShape shape_of_mesh(const TriangleMesh& mesh, VolumeTree tree) {
  double radius_m = 0.0;
  for (const Vector3& vertex : mesh.vertices) {
    radius_m = std::max(radius_m, vertex.norm());
  }
  return {std::make_shared<const TriangleMesh>(mesh),
          std::make_shared<const VolumeTree>(std::move(tree)), solid_of(mesh, 1.0), radius_m};
}

/// A tree that takes less time to build than to fetch is not worth a file.
bool builds_at_once(const TriangleMesh& mesh, const TreeSettings& tree) {
  constexpr std::size_t kFewTriangles = 2000;
  return tree.kind == TreeKind::kOctree && mesh.triangles.size() < kFewTriangles;
}

/// The mesh of any kind but a sphere, a disc, a swept volume or a file. Resolution counts the sides
/// of a torus' or a knot's tube and a quarter of the cells along a creature's length.
TriangleMesh solid_mesh(const ShapeSettings& shape, double metres_per_degree) {
  const auto length_m = [&](const std::optional<double>& measure_deg) {
    return *measure_deg * metres_per_degree;
  };
  switch (shape.kind) {
    case ShapeKind::kBox:
      return box_mesh({length_m(shape.width), length_m(shape.height), length_m(shape.depth)});
    case ShapeKind::kPlate:
      return box_mesh({length_m(shape.width), length_m(shape.height), length_m(shape.thickness)});
    case ShapeKind::kTorus: {
      const int sides = shape.resolution.value_or(10);
      return torus_mesh(length_m(shape.radius), length_m(shape.tube), 3 * sides, sides);
    }
    case ShapeKind::kKnot: {
      const int sides = shape.resolution.value_or(8);
      return knot_mesh(length_m(shape.radius), length_m(shape.tube), 8 * sides, sides);
    }
    case ShapeKind::kCreature:
      return creature_mesh(length_m(shape.length), 4 * shape.resolution.value_or(4));
    case ShapeKind::kPrism:
      return prism_mesh(outline_of(scaled(shape, metres_per_degree)), length_m(shape.thickness));
    default:
      return l_block_mesh(length_m(shape.arm), length_m(shape.thickness));
  }
}

/// A sphere swept along a line or a rectangle, the limbs and trunks of figures: the volume about
/// the origin, and the mesh inscribed in it.
struct SweptShape {
  TriangleMesh mesh;
  Volume volume;
};

SweptShape swept_shape(const ShapeSettings& shape, double metres_per_degree) {
  const auto half_m = [&](const std::optional<double>& measure_deg) {
    return 0.5 * *measure_deg * metres_per_degree;
  };
  const double radius_m = 2.0 * half_m(shape.radius);
  const int cells = 2 * shape.resolution.value_or(4) - 3;
  if (shape.kind == ShapeKind::kLineSwept) {
    const double half_y_m = half_m(shape.length);
    return {swept_mesh(0.0, half_y_m, radius_m, cells),
            LineSwept{Vector3::Zero(), half_y_m * Vector3::UnitY(), radius_m}};
  }
  const double half_x_m = half_m(shape.width);
  const double half_y_m = half_m(shape.height);
  return {swept_mesh(half_x_m, half_y_m, radius_m, cells),
          RectangleSwept{Vector3::Zero(), half_x_m * Vector3::UnitX(), half_y_m * Vector3::UnitY(),
                         radius_m}};
}

/// The mesh with its longest side as long as `size_m`.
TriangleMesh scaled_to(double size_m, TriangleMesh mesh) {
  Eigen::AlignedBox3d bounds;
  for (const Vector3& vertex : mesh.vertices) {
    bounds.extend(vertex);
  }
  const double scale = size_m / bounds.sizes().maxCoeff();
  for (Vector3& vertex : mesh.vertices) {
    vertex *= scale;
  }
  return mesh;
}

std::atomic<std::int64_t>& shapes_built() {
  static std::atomic<std::int64_t> count{0};
  return count;
}

}  // namespace

std::size_t ShapeLibrary::size() const {
  const std::lock_guard lock(building_);
  return shapes_.size();
}

std::int64_t ShapeLibrary::built_by_all() { return shapes_built(); }

VolumeTree ShapeLibrary::tree_of(const TriangleMesh& mesh, const TreeSettings& tree) const {
  return builds_at_once(mesh, tree) ? build_tree(mesh, tree) : cache_.tree(mesh, tree, progress_);
}

BodyShape ShapeLibrary::mesh_shape(const TriangleMesh& solid, const TreeSettings& tree) const {
  const TriangleMesh mesh = about_centre_of_mass(solid);
  return shape_of_mesh(mesh, tree_of(mesh, tree));
}

BodyShape ShapeLibrary::swept_body(const ShapeSettings& description,
                                   const ShapeFrame& frame) const {
  const SweptShape swept = swept_shape(description, frame.metres_per_degree);
  const SweptLevels levels{description.sphere_first.value_or(false),
                           description.deeper.value_or(false)};
  const TriangleMesh mesh = about_centre_of_mass(swept.mesh);
  std::optional<VolumeTree> finer;
  if (const auto settings = finer_settings(levels, frame.tree)) {
    finer = tree_of(mesh, *settings);
  }
  return shape_of_mesh(
      mesh, swept_tree(mesh, swept.volume, levels, frame.tree, finer ? &*finer : nullptr));
}

BodyShape ShapeLibrary::built(const ShapeSettings& description, const Meshes& meshes,
                              const ShapeFrame& frame) const {
  if (description.kind == ShapeKind::kMesh) {
    const double size_m = *description.size * frame.metres_per_degree;
    return mesh_shape(scaled_to(size_m, mesh_content(meshes, *description.file)), frame.tree);
  }
  if (description.kind == ShapeKind::kSphere) {
    return sphere_shape(*description.radius * frame.metres_per_degree);
  }
  if (description.kind == ShapeKind::kDisc) {
    return disc_shape(*description.radius * frame.metres_per_degree);
  }
  if (description.is_swept()) {
    return swept_body(description, frame);
  }
  return mesh_shape(solid_mesh(description, frame.metres_per_degree), frame.tree);
}

const BodyShape& ShapeLibrary::shape(const ShapeSettings& description, const Meshes& meshes,
                                     const ShapeFrame& frame) {
  const bool is_mesh = description.kind == ShapeKind::kMesh;
  const Key key{description,
                is_mesh ? meshes.at(*description.file).hash : "",
                frame.metres_per_degree,
                frame.tree.kind,
                frame.tree.depth,
                frame.tree.branching,
                frame.tree.built_depth};
  const std::lock_guard lock(building_);
  const auto known = shapes_.find(key);
  if (known == shapes_.end()) {
    shapes_[key] = built(description, meshes, frame);
    ++shapes_built();
  }
  return shapes_[key];
}

std::shared_ptr<const DrawnLevels> ShapeLibrary::coarser(
    const std::shared_ptr<const TriangleMesh>& mesh) {
  const std::lock_guard lock(building_);
  std::shared_ptr<const DrawnLevels>& known = coarser_[mesh];
  if (!known) {
    known = std::make_shared<const DrawnLevels>(coarser_meshes(*mesh, progress_));
  }
  return known;
}

}  // namespace impetus::inline scenes
