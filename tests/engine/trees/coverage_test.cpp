// The proof of coverage: zero where nodes cover, the bare area where they do not.
// SPDX-License-Identifier: MIT
#include "engine/trees/coverage.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <string>

#include "engine/numerics/spread_points.hpp"
#include "engine/shapes/solids/ball_meshes.hpp"
#include "engine/shapes/solids/block_meshes.hpp"
#include "engine/shapes/solids/creature_mesh.hpp"
#include "engine/trees/builders/build_tree.hpp"
#include "engine/trees/surface_part.hpp"
#include "tests/engine/one_of_each_kind.hpp"

namespace impetus::coverage_test {

constexpr std::uint64_t kSeed = 67;

struct NamedSolid {
  std::string name;
  TriangleMesh mesh;
};

std::vector<NamedSolid> solids() {
  return {{"box", box_mesh({1.0, 0.6, 0.35})},
          {"dyadic box", box_mesh({1.0, 0.5, 0.25})},
          {"L-block", about_centre_of_mass(l_block_mesh(2.0, 0.7))},
          {"icosphere", icosphere_mesh(0.4, 2)},
          {"creature", about_centre_of_mass(creature_mesh(2.0, 16))}};
}

/// Every kind that build_tree() builds: a new kind is one more row.
std::vector<TreeSettings> settings() {
  return {{TreeKind::kOctree, 4, 8}, {TreeKind::kMedial, 2, 8}, {TreeKind::kMedial, 2, 3},
          {TreeKind::kVoxel, 3, 8},  {TreeKind::kVoxel, 2, 27}, {TreeKind::kBox, 2, 8},
          {TreeKind::kSwept, 2, 8},  {TreeKind::kSwept, 2, 3},  {TreeKind::kHeterogeneous, 2, 8}};
}

/// A tree of one root that holds all and the volumes as its children.
VolumeTree tree_of(const std::vector<Volume>& volumes) {
  std::vector<VolumeNode> nodes{
      {Sphere{Vector3::Zero(), 100.0}, 1, static_cast<std::int32_t>(volumes.size()), {}}};
  for (const Volume& volume : volumes) {
    nodes.push_back({volume, 0, 0, {}});
  }
  return {nodes, {0, 1}};
}

double uncovered_by(const TriangleMesh& mesh, const std::vector<Volume>& volumes) {
  return uncovered_area_m2(mesh, tree_of(volumes), 1);
}

/// By points spread over each triangle.
double sampled_uncovered_m2(const TriangleMesh& mesh, const std::vector<Volume>& volumes,
                            int samples) {
  double bare_m2 = 0.0;
  for (const Facet& facet : whole_surface(mesh)) {
    int bare = 0;
    for (int index = 1; index <= samples; ++index) {
      double s = spread_share(index, 2);
      double t = spread_share(index, 3);
      if (s + t > 1.0) {
        s = 1.0 - s;
        t = 1.0 - t;
      }
      const Vector3 point = facet.corners[0] + s * (facet.corners[1] - facet.corners[0]) +
                            t * (facet.corners[2] - facet.corners[0]);
      bare += std::none_of(volumes.begin(), volumes.end(),
                           [&](const Volume& volume) { return holds(volume, point); })
                  ? 1
                  : 0;
    }
    bare_m2 += area_m2({facet}) * bare / samples;
  }
  return bare_m2;
}

std::vector<Volume> volumes_at(const VolumeTree& tree, int level) {
  std::vector<Volume> volumes;
  for (const std::int32_t node : tree.standing_at(level)) {
    volumes.push_back(tree.volume(node));
  }
  return volumes;
}

TEST(Coverage, EveryLevelOfEveryKindOfTreeCoversTheWholeSurface) {
  for (const TreeSettings& kind : settings()) {
    for (const auto& [name, mesh] : solids()) {
      const VolumeTree tree = build_tree(mesh, kind);
      // Boxes of an L-block end where nothing is left to better; spheres never do.
      const bool of_spheres = !tree.volumes().all_spheres().empty();
      ASSERT_TRUE(tree.level_count() > 2 || !of_spheres) << name_of(kind.kind) << " of " << name;
      for (int level = 0; level < tree.level_count(); ++level) {
        EXPECT_EQ(uncovered_area_m2(mesh, tree, level), 0.0)
            << name_of(kind.kind) << " of " << name << ", level " << level;
      }
    }
  }
}

TEST(Coverage, ANodeThatIsTooSmallOrMissingLeavesWhatSamplesSay) {
  const TriangleMesh mesh = about_centre_of_mass(l_block_mesh(2.0, 0.7));
  const VolumeTree tree = build_tree(mesh, {TreeKind::kOctree, 3, 8});
  const std::vector<Volume> volumes = volumes_at(tree, 2);
  int bared = 0;
  for (std::size_t node = 0; node < volumes.size(); ++node) {
    std::vector<Volume> shrunk = volumes;
    std::get<Sphere>(shrunk[node]).radius_m *= 1.0 - 0.01 / 3.0;  // 1% of the volume
    std::vector<Volume> without = volumes;
    without.erase(without.begin() + static_cast<std::ptrdiff_t>(node));
    const double shrunk_m2 = uncovered_by(mesh, shrunk);
    const double without_m2 = uncovered_by(mesh, without);
    // A triangle's 4,000 points miss by 1% or so of its area.
    EXPECT_NEAR(without_m2, sampled_uncovered_m2(mesh, without, 4'000), 0.01 + 0.02 * without_m2);
    EXPECT_LE(shrunk_m2, without_m2 + 1e-12);
    bared += shrunk_m2 > 0.0 ? 1 : 0;
  }
  EXPECT_GT(bared, static_cast<int>(volumes.size()) / 2)
      << "a sphere round a cell touches the farthest corner, which it alone may hold";
}

TEST(Coverage, TheBareAreaIsThatOfTheDiscThatASphereLeavesOut) {
  // A sphere about a cube that dips below each face's corners: on each face it covers a disc.
  const TriangleMesh mesh = box_mesh({2.0, 2.0, 2.0});
  const double radius = 1.2;
  const double disc_m2 = std::numbers::pi * (radius * radius - 1.0);
  EXPECT_NEAR(uncovered_by(mesh, {Sphere{Vector3::Zero(), radius}}), 6.0 * (4.0 - disc_m2),
              1e-3 * 24.0);
}

TEST(Coverage, AVolumeInTheMiddleOfATriangleTakesItsSectionAway) {
  // No edge meets it, so only halving finds it.
  const TriangleMesh mesh = box_mesh({2.0, 2.0, 2.0});
  const double disc_m2 = std::numbers::pi * 0.01;
  EXPECT_NEAR(uncovered_by(mesh, {Sphere{{0.4, -0.35, 1.0}, 0.1}}), 24.0 - disc_m2, 1e-3 * 24.0);
  EXPECT_NEAR(uncovered_by(mesh, {Cube{{0.4, -0.35, 1.0}, 0.1}}), 24.0 - 0.04, 1e-3 * 24.0);
}

TEST(Coverage, IsNeverLessThanSamplesSayForVolumesOfEveryKind) {
  RandomStream random(kSeed, "kinds");
  const TriangleMesh mesh = icosphere_mesh(0.7, 1);
  for (int trial = 0; trial < 6; ++trial) {
    std::vector<Volume> volumes;
    for (int group = 0; group < 3; ++group) {
      for (const Volume& volume : one_of_each_kind(random, random_in_cube(random, 0.6), 0.8)) {
        volumes.push_back(volume);
      }
    }
    for (std::size_t count = 1; count <= volumes.size(); count += 5) {
      const std::vector<Volume> some(volumes.begin(),
                                     volumes.begin() + static_cast<std::ptrdiff_t>(count));
      const double sampled_m2 = sampled_uncovered_m2(mesh, some, 500);
      const double bare_m2 = uncovered_by(mesh, some);
      EXPECT_NEAR(bare_m2, sampled_m2, 0.03) << "of 5.5; seed " << kSeed << ", trial " << trial;
    }
  }
}

TEST(Coverage, BoxesThatShareFacesLeaveNoSeam) {
  // A third has no exact double: neighbours' faces differ by rounding.
  const TriangleMesh mesh = icosphere_mesh(0.49, 3);
  std::vector<Volume> cubes;
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      for (int z = -1; z <= 1; ++z) {
        cubes.emplace_back(Cube{Vector3(x, y, z) / 3.0, 1.0 / 6.0});
      }
    }
  }
  EXPECT_EQ(uncovered_by(mesh, cubes), 0.0);
  const double whole_m2 = area_m2(whole_surface(mesh));
  std::vector<Volume> corner_gone(cubes.begin() + 1, cubes.end());
  const double hole_m2 = uncovered_by(mesh, corner_gone);
  EXPECT_NEAR(hole_m2, sampled_uncovered_m2(mesh, corner_gone, 200), 1e-3 * whole_m2);
  EXPECT_GT(hole_m2, 0.01 * whole_m2);
}

TEST(Coverage, AGapOfAThousandthOfAPartIsFound) {
  const TriangleMesh mesh = box_mesh({1.0, 1.0, 1.0});
  const double gap_m = 1e-3;
  const Box half{{0.5, 0.0, 0.0}, {0.5 - gap_m / 2.0, 1.0, 1.0}};
  const Box other{{-0.5, 0.0, 0.0}, half.half_extents_m};
  EXPECT_NEAR(uncovered_by(mesh, {half, other}), 4.0 * gap_m, 1e-6) << "round four sides";
}

TEST(Coverage, NothingIsCoveredByVolumesElsewhere) {
  const TriangleMesh mesh = box_mesh({1.0, 2.0, 3.0});
  EXPECT_NEAR(uncovered_by(mesh, {Sphere{{50.0, 0.0, 0.0}, 1.0}}), 22.0, 1e-12);
}

}  // namespace impetus::coverage_test
