// The mesh by which volumes are drawn: closed, outward, and of the volume's own content.
// SPDX-License-Identifier: MIT
#ifdef IMPETUS_PROGRAM_HAS_WINDOW

#include "experiments/drawing/rounded_box_mesh.hpp"

#include <gtest/gtest.h>

#include "engine/shapes/mass_properties.hpp"

namespace impetus::rounded_box_mesh_test {

TriangleMesh stretched(const RoundedBoxMesh& mesh, const RoundedBox& box) {
  TriangleMesh result;
  for (const RoundedBoxMesh::Vertex& vertex : mesh.vertices) {
    const Vector3 corner(vertex.corner[0], vertex.corner[1], vertex.corner[2]);
    const Vector3 normal(vertex.normal[0], vertex.normal[1], vertex.normal[2]);
    result.vertices.push_back(
        box.placed(corner.cwiseProduct(box.half_extents_m) + box.radius_m * normal));
  }
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    result.triangles.push_back({mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2]});
  }
  return result;
}

TEST(RoundedBoxMesh, IsClosedAndOutwardAtEveryFineness) {
  for (const int parts : {1, 2, 4, 8, 14}) {
    const TriangleMesh mesh = stretched(
        rounded_box_mesh(parts), {Vector3::Zero(), Matrix3::Identity(), {1.0, 0.5, 2.0}, 0.3});
    EXPECT_TRUE(find_defects(mesh).none()) << parts;
    EXPECT_GT(solid_of(mesh, 1.0).volume_m3, 8.0) << parts;  // the box within is 2 × 1 × 4
  }
}

TEST(RoundedBoxMesh, HasTheContentOfEveryKindOfVolume) {
  const Quaternion turn = Quaternion(0.9, 0.3, -0.2, 0.1).normalized();
  const std::vector<Volume> volumes{
      Sphere{{1, 2, 3}, 0.7}, LineSwept{{0, 1, 0}, {0.5, 0.5, -1.0}, 0.4},
      RectangleSwept{{0, 0, 1}, {0.5, 0.5, 0}, {-0.4, 0.4, 0}, 0.2},
      Box{{1, 0, 0}, {0.3, 0.5, 0.9}, turn}, Cube{{0, 0, 0}, 0.6, turn}};
  const RoundedBoxMesh finest = rounded_box_mesh(14);
  for (const Volume& volume : volumes) {
    const TriangleMesh mesh = stretched(finest, rounded_box(volume));
    double six_volumes = 0.0;  // flat pieces are no solid, but add nothing here
    for (const auto& [a, b, c] : mesh.triangles) {
      six_volumes += mesh.vertices[a].dot(mesh.vertices[b].cross(mesh.vertices[c]));
    }
    // Facets that span 6.4° lose less than 1 % of a ball; those of a box lose nothing.
    EXPECT_NEAR(six_volumes / 6.0 / content_m3(volume), 1.0, 0.01) << volume.index();
    for (const Vector3& vertex : mesh.vertices) {
      const Vector3 inwards = 1e-6 * (bounding_sphere(volume).centre - vertex);
      EXPECT_TRUE(holds(volume, vertex + inwards)) << volume.index();
    }
  }
}

}  // namespace impetus::rounded_box_mesh_test

#endif
