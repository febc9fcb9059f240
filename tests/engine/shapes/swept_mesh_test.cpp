// Meshes and trees of bodies that are swept volumes: closed, inscribed, held at every level.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "engine/shapes/mass_properties.hpp"
#include "engine/shapes/solids/ball_meshes.hpp"
#include "engine/shapes/surface_distance.hpp"
#include "engine/trees/builders/build_tree.hpp"
#include "engine/trees/builders/swept_tree.hpp"
#include "engine/trees/coverage.hpp"
#include "engine/trees/node_description.hpp"
#include "engine/volumes/rounded_box.hpp"
#include "tests/engine/builders.hpp"

namespace impetus::swept_mesh_test {

constexpr double kHalfX_m = 0.4;
constexpr double kHalfY_m = 0.25;
constexpr double kRadius_m = 0.1;

/// Halves of the core: of a ball, of lines both ways, of a rectangle.
const std::vector<std::pair<double, double>> kCores{
    {0.0, 0.0}, {0.0, kHalfY_m}, {kHalfX_m, 0.0}, {kHalfX_m, kHalfY_m}};

RectangleSwept volume_of(double half_x_m, double half_y_m) {
  return {Vector3::Zero(), half_x_m * Vector3::UnitX(), half_y_m * Vector3::UnitY(), kRadius_m};
}

TEST(SweptMesh, IsClosedAndOutwardWithTwelveTrianglesForEachCell) {
  for (const auto& [x, y] : kCores) {
    for (const int cells : {1, 5, 9, 21}) {
      const TriangleMesh mesh = swept_mesh(x, y, kRadius_m, cells);
      EXPECT_TRUE(find_defects(mesh).none()) << x << " " << y << " " << cells;
      EXPECT_EQ(mesh.triangles.size(), static_cast<std::size_t>(12 * cells * cells));
      EXPECT_GT(solid_of(mesh, 1.0).volume_m3, 0.0);
    }
  }
}

// distance of (x, y, z) from the core = √(max(|x| − a, 0)² + max(|y| − b, 0)² + z²) = radius
TEST(SweptMesh, HasItsVerticesOnTheSweptSurface) {
  for (const auto& [a, b] : kCores) {
    for (const Vector3& p : swept_mesh(a, b, kRadius_m, 7).vertices) {
      const Vector3 beyond(std::max(std::abs(p.x()) - a, 0.0), std::max(std::abs(p.y()) - b, 0.0),
                           p.z());
      EXPECT_NEAR(beyond.norm(), kRadius_m, 1e-15);
    }
  }
}

// ball + cylinders + slab, which the error of an inscribed mesh approaches with the cells' square
TEST(SweptMesh, ApproachesTheVolumeFromWithin) {
  for (const auto& [x, y] : kCores) {
    const double exact_m3 = content_m3(volume_of(x, y));
    const double coarse_m3 = exact_m3 - solid_of(swept_mesh(x, y, kRadius_m, 7), 1.0).volume_m3;
    const double fine_m3 = exact_m3 - solid_of(swept_mesh(x, y, kRadius_m, 21), 1.0).volume_m3;
    EXPECT_GT(fine_m3, 0.0);
    EXPECT_NEAR(coarse_m3 / fine_m3, 9.0, 0.9);
    EXPECT_LT(coarse_m3, 0.05 * exact_m3);
  }
}

TEST(SweptMesh, IsConvex) {
  for (const auto& [x, y] : kCores) {
    for (const int cells : {1, 3, 5, 9, 21}) {
      const TriangleMesh mesh = swept_mesh(x, y, kRadius_m, cells);
      for (const auto& [a, b, c] : mesh.triangles) {
        const Vector3& corner = mesh.vertices[a];
        const Vector3 normal =
            (mesh.vertices[b] - corner).cross(mesh.vertices[c] - corner).normalized();
        for (const Vector3& vertex : mesh.vertices) {
          ASSERT_LT(normal.dot(vertex - corner), 1e-14) << x << " " << y << " " << cells;
        }
      }
    }
  }
}

// Points of the volume's surface, as far from the mesh as the tree says at most.
TEST(SweptMesh, HoldsTheSameCoreSweptByItsInnerRadius) {
  RandomStream random(41, "swept");
  for (const auto& [x, y] : kCores) {
    const TriangleMesh mesh = swept_mesh(x, y, kRadius_m, 5);
    const double inner_m = swept_inner_radius_m(mesh, x * Vector3::UnitX(), y * Vector3::UnitY());
    EXPECT_GT(inner_m, 0.94 * kRadius_m);
    EXPECT_LT(inner_m, kRadius_m);
    for (int draw = 0; draw < 500; ++draw) {
      const Vector3 core(uniform_in(random, -x, x), uniform_in(random, -y, y), 0.0);
      const Vector3 point = core + (1.0 - 1e-9) * inner_m * random_direction(random);
      ASSERT_TRUE(contains(mesh, point)) << point.transpose();
    }
  }
}

TEST(SweptMesh, IsAsLongAsItsVolumeAndLiesAboutItsCentreOfMass) {
  const TriangleMesh mesh = swept_mesh(kHalfX_m, kHalfY_m, kRadius_m, 5);
  Eigen::AlignedBox3d bounds;
  for (const Vector3& vertex : mesh.vertices) {
    bounds.extend(vertex);
  }
  EXPECT_LT(bounds.sizes().x(), 2.0 * (kHalfX_m + kRadius_m));
  EXPECT_GT(bounds.sizes().x(), 2.0 * (kHalfX_m + 0.95 * kRadius_m));
  EXPECT_LT(solid_of(mesh, 1.0).centre.norm(), 1e-15);
}

/// The greatest distance found at points of the volume's surface.
double sampled_reach_m(const Volume& volume, const SurfaceDistance& solid) {
  RandomStream random(42, "reach");
  const RoundedBox form = rounded_box(volume);
  double worst_m = 0.0;
  for (int draw = 0; draw < 3'000; ++draw) {
    const Vector3 core = random_in_cube(random, 1.0).cwiseProduct(form.half_extents_m);
    const Vector3 point = form.placed(core + form.radius_m * random_direction(random));
    worst_m = std::max(worst_m, solid.signed_distance_m(point));
  }
  return worst_m;
}

class SweptTree : public ::testing::Test {
 protected:
  VolumeTree tree(const SweptLevels& levels, const TreeSettings& settings) const {
    const auto finer = finer_settings(levels, settings);
    const auto built = finer ? std::optional(build_tree(mesh_, *finer)) : std::nullopt;
    return swept_tree(mesh_, volume_of(kHalfX_m, kHalfY_m), levels, settings,
                      built ? &*built : nullptr);
  }

  TriangleMesh mesh_ = about_centre_of_mass(swept_mesh(kHalfX_m, kHalfY_m, kRadius_m, 5));
};

TEST_F(SweptTree, IsTheVolumeAloneWhereNothingElseIsAskedFor) {
  const VolumeTree alone = tree({}, {TreeKind::kOctree, 3});
  ASSERT_EQ(alone.node_count(), 1);
  const Volume root = alone.volume(0);
  ASSERT_TRUE(std::holds_alternative<RectangleSwept>(root));
  EXPECT_NEAR(std::get<RectangleSwept>(root).radius_m, kRadius_m, 1e-11);
  EXPECT_EQ(std::get<RectangleSwept>(root).half_u, kHalfX_m * Vector3::UnitX());
}

TEST_F(SweptTree, HasNoMoreLevelsThanItsSettings) {
  for (const int depth : {0, 1, 2, 3}) {
    for (const int built : {0, 1, 3}) {
      TreeSettings settings{TreeKind::kOctree, depth};
      settings.built_depth = built;
      const int most = 1 + std::min(depth, built);
      EXPECT_EQ(tree({true, true}, settings).level_count(), most) << depth << " " << built;
      EXPECT_EQ(tree({false, true}, settings).level_count(), most) << depth << " " << built;
      EXPECT_EQ(tree({true, false}, settings).level_count(), std::min(most, 2));
    }
  }
}

TEST_F(SweptTree, HoldsTheMeshAtEveryLevel) {
  for (const TreeKind kind : {TreeKind::kOctree, TreeKind::kSwept, TreeKind::kMedial}) {
    const VolumeTree whole = tree({true, true}, {kind, 3, 8});
    ASSERT_GE(whole.level_count(), 3);
    EXPECT_TRUE(std::holds_alternative<Sphere>(whole.volume(0)));
    EXPECT_TRUE(std::holds_alternative<RectangleSwept>(whole.volume(1)));
    for (int level = 0; level < whole.level_count(); ++level) {
      EXPECT_EQ(uncovered_area_m2(mesh_, whole, level), 0.0) << level;
    }
  }
}

TEST_F(SweptTree, KeepsTheLevelsOfTheBuiltTree) {
  const TreeSettings settings{TreeKind::kOctree, 3};
  const VolumeTree built = build_tree(mesh_, settings);
  const VolumeTree whole = tree({false, true}, settings);
  ASSERT_EQ(whole.node_count(), built.node_count());
  for (std::int32_t node = 1; node < built.node_count(); ++node) {
    EXPECT_EQ(whole.links(node), built.links(node));
    EXPECT_EQ(whole.surface(node), built.surface(node));
    EXPECT_EQ(bounding_sphere(whole.volume(node)).centre,
              bounding_sphere(built.volume(node)).centre);
  }
}

// The sampled occupancy is within about .03 of the truth.
TEST_F(SweptTree, DescribesItsNodesAsABuilderWould) {
  const VolumeTree whole = tree({true, false}, {TreeKind::kOctree, 1});
  const NodeDescription description(mesh_);
  for (const std::int32_t node : {0, 1}) {
    const NodeSurface sampled = description.of(whole.volume(node), whole_surface(mesh_));
    EXPECT_NEAR(whole.surface(node).occupancy, sampled.occupancy, 0.03F);
    EXPECT_LE(whole.surface(node).occupancy, 1.0F);
    EXPECT_EQ(whole.surface(node).density_normal, sampled.density_normal);
  }
}

TEST_F(SweptTree, TellsHowFarItReaches) {
  const VolumeTree whole = tree({true, false}, {TreeKind::kOctree, 1});
  // The sphere reaches farthest beyond the flat side, the volume by its cells' arcs.
  const double sphere_m = std::hypot(kHalfX_m, kHalfY_m) + kRadius_m;
  EXPECT_NEAR(whole.fit_error_m(0), sphere_m - kRadius_m, 0.06 * kRadius_m);
  EXPECT_LT(whole.fit_error_m(1), 0.06 * kRadius_m);
  EXPECT_GT(whole.fit_error_m(1), 0.0);
  const SurfaceDistance distance(mesh_);
  for (const int level : {0, 1}) {
    EXPECT_GE(whole.fit_error_m(level), sampled_reach_m(whole.volume(level), distance)) << level;
  }
}

}  // namespace impetus::swept_mesh_test
