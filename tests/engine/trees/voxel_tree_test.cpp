// The voxel tree: cells of a grid, disjoint, each in its parent's, and together round the solid.
// SPDX-License-Identifier: MIT
#include "engine/trees/builders/voxel_tree.hpp"

#include <set>

#include "engine/shapes/surface_distance.hpp"
#include "tests/engine/builders.hpp"
#include "tests/engine/built_solids.hpp"
#include "tests/engine/mesh_oracles.hpp"

namespace impetus::voxel_tree_test {

TreeSettings voxels(int depth, int branching) { return {TreeKind::kVoxel, depth, branching}; }

std::vector<BuiltSolid> solids() {
  std::vector<BuiltSolid> all = small_solids();
  all.push_back({"creature", about_centre_of_mass(creature_mesh(1.0, 16))});
  return all;
}

TEST(VoxelTree, PartsTileTheSurfaceAndEveryNodeHoldsItsPart) {
  for (const auto& [name, mesh] : solids()) {
    expect_covers(build_voxel_tree(mesh, voxels(3, 8)), mesh, name);
    expect_covers(build_voxel_tree(mesh, voxels(2, 27)), mesh, name);
  }
}

TEST(VoxelTree, CellsOfALevelDifferAndLieInTheirParents) {
  for (const int k : {2, 3, 4}) {
    for (const auto& [name, mesh] : solids()) {
      const VolumeTree tree = build_voxel_tree(mesh, voxels(2, k * k * k)).tree;
      std::uint32_t along = 1;
      for (int level = 0; level < tree.level_count(); ++level, along *= k) {
        const std::vector<std::uint32_t>& cells = tree.volumes().cells();
        const std::set<std::uint32_t> different(cells.begin() + tree.level_begin(level),
                                                cells.begin() + tree.level_end(level));
        EXPECT_EQ(static_cast<std::int32_t>(different.size()),
                  tree.level_end(level) - tree.level_begin(level))
            << name;
        for (std::int32_t node = tree.level_begin(level); node < tree.level_end(level); ++node) {
          const auto place = [&](std::int32_t of, std::uint32_t n) {
            const std::uint32_t cell = cells[static_cast<std::size_t>(of)];
            return std::array{cell % n, cell / n % n, cell / n / n};
          };
          const auto& [first, count] = tree.links(node);
          for (std::int32_t child = first; child < first + count; ++child) {
            for (std::size_t axis = 0; axis < 3; ++axis) {
              ASSERT_EQ(place(child, along * k)[axis] / k, place(node, along)[axis]) << name;
            }
          }
        }
      }
    }
  }
}

TEST(VoxelTree, HoldsExactlyTheCellsThatTheSolidTouches) {
  // Against the brute-force oracle: a cell whose middle is inside, or no nearer to the surface than
  // half its diagonal, is settled by its middle alone.
  const double half_diagonal = std::sqrt(3.0) / 2.0;
  for (const auto& [name, mesh] : solids()) {
    const VolumeTree tree = build_voxel_tree(mesh, voxels(3, 8)).tree;
    const VoxelGrid& grid = tree.volumes().grid();
    std::set<std::uint32_t> standing;  // cells of level 3, those under leaves included
    for (const std::int32_t node : tree.standing_at(3)) {
      const auto cube = std::get<Cube>(tree.volume(node));
      const double edge_m = grid.edge_m / 8.0;
      const Vector3 centre = (cube.centre - grid.least) / edge_m;
      for (int x = 0; x < 8; ++x) {
        for (int y = 0; y < 8; ++y) {
          for (int z = 0; z < 8; ++z) {
            const Vector3 middle(x + 0.5, y + 0.5, z + 0.5);
            if ((middle - centre).cwiseAbs().maxCoeff() < cube.half_edge_m / edge_m) {
              standing.insert(static_cast<std::uint32_t>(x + 8 * (y + 8 * z)));
            }
          }
        }
      }
    }
    int settled = 0;
    for (std::uint32_t cell = 0; cell < 512; ++cell) {
      const Vector3 place(cell % 8 + 0.5, cell / 8 % 8 + 0.5, cell / 64 + 0.5);
      const Vector3 middle = grid.least + grid.edge_m / 8.0 * place;
      const double distance_m = distance_to_surface(mesh, middle);
      const bool inside = contains(mesh, middle);
      if (inside && distance_m > 1e-9 * grid.edge_m) {
        ASSERT_EQ(standing.count(cell), 1U) << name << ", cell " << cell;
      } else if (!inside && distance_m > half_diagonal * grid.edge_m / 8.0 * (1.0 + 1e-9)) {
        ASSERT_EQ(standing.count(cell), 0U) << name << ", cell " << cell;
        ++settled;
      }
    }
    EXPECT_GT(settled, 0) << name;
  }
}

TEST(VoxelTree, AFaceInAWallHasNoCellsBeyondIt) {
  // A dyadic box fills its cells exactly: no slivers on the other side of any wall.
  const VolumeTree tree = build_voxel_tree(box_mesh({1.0, 0.5, 0.25}), voxels(3, 8)).tree;
  for (const std::int32_t node : tree.standing_at(3)) {
    const auto cube = std::get<Cube>(tree.volume(node));
    const Vector3 most = cube.centre.cwiseAbs() + Vector3::Constant(cube.half_edge_m);
    EXPECT_LT((most - Vector3(0.5, 0.25, 0.125)).maxCoeff(), 1e-9) << "node " << node;
  }
}

TEST(VoxelTree, CellsWhollyInsideAreLeavesThatReachNowhere) {
  const TriangleMesh mesh = icosphere_mesh(0.4, 2);
  const BuiltTree built = build_voxel_tree(mesh, voxels(4, 8));
  int inside = 0;
  for (std::int32_t node = 0; node < built.tree.node_count(); ++node) {
    if (built.parts[static_cast<std::size_t>(node)].empty()) {
      ++inside;
      const auto cube = std::get<Cube>(built.tree.volume(node));
      EXPECT_TRUE(contains(mesh, cube.centre));
      EXPECT_GT(distance_to_surface(mesh, cube.centre), 0.999 * cube.half_edge_m);
      EXPECT_EQ(built.tree.links(node).child_count, 0);
      EXPECT_EQ(built.tree.surface(node).fit_error_m, 0.0F);
      EXPECT_EQ(built.tree.surface(node).occupancy, 1.0F);
    }
  }
  EXPECT_GT(inside, 50);
}

TEST(VoxelTree, TakesFourBytesANodeForItsVolumes) {
  const VolumeTree tree = build_voxel_tree(icosphere_mesh(0.4, 2), voxels(4, 8)).tree;
  EXPECT_LE(tree.volumes().bytes(), 4 * static_cast<std::size_t>(tree.node_count()) + 64);
}

TEST(VoxelTree, IsTheSameEveryTime) {
  const TriangleMesh mesh = torus_mesh(1.0, 0.3, 16, 8);
  const VolumeTree once = build_voxel_tree(mesh, voxels(3, 27)).tree;
  const VolumeTree again = build_voxel_tree(mesh, voxels(3, 27)).tree;
  EXPECT_EQ(once.volumes().cells(), again.volumes().cells());
  EXPECT_EQ(once.volumes().grid(), again.volumes().grid());
}

}  // namespace impetus::voxel_tree_test
