// SPDX-License-Identifier: MIT
#include "tests/bench/crowd_shape.hpp"

#include <algorithm>

#include "experiments/files/mesh_file.hpp"
#include "experiments/models/named_shape.hpp"
#include "experiments/models/tree_cache.hpp"

namespace impetus {
namespace {

TriangleMesh of_radius_one(TriangleMesh mesh) {
  double radius_m = 0.0;
  for (const Vector3& vertex : mesh.vertices) {
    radius_m = std::max(radius_m, vertex.norm());
  }
  for (Vector3& vertex : mesh.vertices) {
    vertex /= radius_m;
  }
  return mesh;
}

std::shared_ptr<const VolumeTree> medial(const TriangleMesh& mesh, int depth) {
  return std::make_shared<VolumeTree>(
      TreeCache::of_user().tree(mesh, {TreeKind::kMedial, depth, /*branching=*/8}));
}

}  // namespace

CrowdShape crowd_shape(const std::optional<std::string>& file) {
  CrowdShape shape;
  shape.name = file ? *file : "creature";
  shape.mesh =
      of_radius_one(about_centre_of_mass(file ? load_mesh(*file) : shape_named("creature")));
  shape.mass = solid_of(shape.mesh, kSolidDensity_kg_m3);
  shape.coarse = medial(shape.mesh, 2);
  shape.fine = medial(shape.mesh, 3);
  return shape;
}

BodyModel model_of(const CrowdShape& shape, const std::shared_ptr<const VolumeTree>& tree) {
  BodyModel model;
  model.name = shape.name;
  model.tree = tree;
  model.inverse_mass = 1.0 / shape.mass.mass_kg;
  model.inverse_inertia = shape.mass.inertia.inverse();
  return model;
}

int leaf_count(const VolumeTree& tree) {
  int leaves = 0;
  for (std::int32_t node = 0; node < tree.node_count(); ++node) {
    leaves += tree.links(node).child_count == 0 ? 1 : 0;
  }
  return leaves;
}

}  // namespace impetus
