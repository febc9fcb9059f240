// The shapes that scenes name, built once each: mesh, mass and volume tree.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <tuple>
#include <utility>

#include "engine/shapes/mass_properties.hpp"
#include "engine/shapes/triangle_mesh.hpp"
#include "engine/trees/volume_tree.hpp"
#include "experiments/models/tree_cache.hpp"
#include "experiments/record/staged_scene.hpp"
#include "experiments/scenes/shape_settings.hpp"

namespace impetus::inline scenes {

/// A shape in the frame of its centre of mass.
struct BodyShape {
  std::shared_ptr<const TriangleMesh> mesh;  ///< none: a sphere of `radius_m`
  std::shared_ptr<const VolumeTree> tree;
  MassProperties unit_mass;  ///< at a density of 1 kg/m³
  double radius_m{0.0};      ///< of a ball about the centre of mass that holds the shape
};

/// What a shape depends on beyond its description.
struct ShapeFrame {
  double metres_per_degree{1.0};
  TreeSettings tree;
};

/// May be used by several threads, but for tell().
class ShapeLibrary {
 public:
  /// Trees that take long to build are kept in `cache`: they are the same with it and without.
  explicit ShapeLibrary(TreeCache cache = TreeCache::of_user()) : cache_(std::move(cache)) {}

  /// From now on `progress` hears of what takes long, shape by shape.
  void tell(Progress progress) { progress_ = std::move(progress); }

  /// The shape of a scene's body, its measures in degrees; `meshes` is the scene's. Precondition:
  /// add_shape_problems() adds none.
  const BodyShape& shape(const ShapeSettings& description, const Meshes& meshes,
                         const ShapeFrame& frame);

  /// How many shapes this library has built.
  [[nodiscard]] std::size_t size() const;

  /// How many all libraries of this process have built.
  [[nodiscard]] static std::int64_t built_by_all();

  /// The meshes to draw in place of a shape's mesh where there is a crowd of it.
  std::shared_ptr<const DrawnLevels> coarser(const std::shared_ptr<const TriangleMesh>& mesh);

 private:
  /// Description and hash of a mesh, metres per degree; kind, depth, branching and levels built of
  /// the tree.
  using Key = std::tuple<ShapeSettings, std::string, double, TreeKind, int, int, int>;

  [[nodiscard]] BodyShape built(const ShapeSettings& description, const Meshes& meshes,
                                const ShapeFrame& frame) const;
  [[nodiscard]] VolumeTree tree_of(const TriangleMesh& mesh, const TreeSettings& tree) const;
  [[nodiscard]] BodyShape mesh_shape(const TriangleMesh& solid, const TreeSettings& tree) const;
  [[nodiscard]] BodyShape swept_body(const ShapeSettings& description,
                                     const ShapeFrame& frame) const;

  TreeCache cache_;
  Progress progress_;
  /// Held from looking for a shape to having it; what is built stays.
  mutable std::mutex building_;
  std::map<Key, BodyShape> shapes_;
  std::map<std::shared_ptr<const TriangleMesh>, std::shared_ptr<const DrawnLevels>> coarser_;
};

}  // namespace impetus::inline scenes
