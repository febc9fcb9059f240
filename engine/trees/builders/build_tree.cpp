// SPDX-License-Identifier: MIT
#include "engine/trees/builders/build_tree.hpp"

#include <cmath>
#include <utility>

#include "engine/trees/builders/fitted_tree.hpp"
#include "engine/trees/builders/medial_tree.hpp"
#include "engine/trees/builders/octree.hpp"
#include "engine/trees/builders/voxel_tree.hpp"
#include "engine/trees/node_description.hpp"

namespace impetus::inline trees {
namespace {

// The tree of volumes of any kind: mixed, or of spheres alone where mixing is not worth it.
//
//   volumes that suit each node ─┐
//                                ├─> least reach beyond the solid x sqrt(cost of a test)
//   medial spheres ──────────────┘
//
// Spheres are tested by blocks of siblings, but only where a tree has nothing else: one other
// volume anywhere makes every test of the tree kMixedTestCost times as dear (engine/README.md, "The
// budget"; tests/bench/README.md, "The trade"). An error falls as the square root of what is spent
// on it (fitted_tree.cpp), so mixed volumes must reach sqrt(kMixedTestCost) times less.

/// One test of mixed volumes, 12 to 29 units as measured, over one of blocks of spheres, .15 to .4.
constexpr double kMixedTestCost = 60.0;

double finest_reach_m(const VolumeTree& tree) { return tree.fit_error_m(tree.level_count() - 1); }

bool is_as_good_as_exact(const VolumeTree& tree) {
  constexpr double kNegligible = 1e-6;  // of the size
  return finest_reach_m(tree) <= kNegligible * tree.bounding_radius_m();
}

bool is_worth_its_price(const VolumeTree& mixed, const VolumeTree& spheres) {
  const double price = mixed.volumes().all_spheres().empty() ? std::sqrt(kMixedTestCost) : 1.0;
  return finest_reach_m(mixed) * price <= finest_reach_m(spheres);
}

/// The part of `progress` from `begin` to `end`.
Progress part_of(const Progress& progress, double begin, double end) {
  return [&progress, begin, end](double share) {
    if (progress) {
      progress(begin + share * (end - begin));
    }
  };
}

/// A tree of kind kHeterogeneous; see build_tree().
BuiltTree heterogeneous_tree(const TriangleMesh& solid, const TreeSettings& settings,
                             const Progress& progress) {
  // Whole trees are compared, so that the choice is the same however many levels are then kept.
  const TreeSettings whole{settings.kind, settings.depth, settings.branching};
  const TreeSettings whole_of_spheres{TreeKind::kMedial, settings.depth, settings.branching};
  const bool keeps_all = levels_to_build(settings) == settings.depth;
  BuiltTree mixed = build_fitted_tree(solid, whole, part_of(progress, 0.0, 0.6));
  bool is_mixed = is_as_good_as_exact(mixed.tree);
  if (!is_mixed) {
    BuiltTree spheres = medial_tree(solid, whole_of_spheres, part_of(progress, 0.6, 1.0));
    is_mixed = is_worth_its_price(mixed.tree, spheres.tree);
    if (!is_mixed && keeps_all) {
      return spheres;
    }
  }
  if (is_mixed) {
    return keeps_all ? std::move(mixed) : build_fitted_tree(solid, settings);
  }
  TreeSettings upper_levels = whole_of_spheres;
  upper_levels.built_depth = settings.built_depth;
  return medial_tree(solid, upper_levels);
}

}  // namespace

VolumeTree build_tree(const TriangleMesh& solid, const TreeSettings& settings,
                      const Progress& progress) {
  require_buildable(solid, settings);
  if (progress) {
    progress(0.0);
  }
  switch (settings.kind) {
    case TreeKind::kBox:
    case TreeKind::kSwept:
      return build_fitted_tree(solid, settings, progress).tree;
    case TreeKind::kHeterogeneous:
      return heterogeneous_tree(solid, settings, progress).tree;
    case TreeKind::kVoxel:
      return build_voxel_tree(solid, settings, progress).tree;
    case TreeKind::kMedial:
      return medial_tree(solid, settings, progress).tree;
    case TreeKind::kOctree:
    default:
      return octree(solid, levels_to_build(settings));
  }
}

}  // namespace impetus::inline trees
