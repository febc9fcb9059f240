// The tree of volumes of any kind: mixed, or of spheres alone where mixing is not worth it.
//
//   volumes that suit each node ─┐
//                                ├─> least reach beyond the solid x sqrt(cost of a test)
//   medial spheres ──────────────┘
//
// Spheres are tested by blocks of siblings, but only where a tree has nothing else: one other
// volume anywhere makes every test of the tree kMixedTestCost times as dear (engine/README.md, "The
// budget"; tests/bench/README.md, "The trade"). An error falls as the square root of what is spent
// on it (kind_choice.hpp), so mixed volumes must reach sqrt(kMixedTestCost) times less.
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/shapes/triangle_mesh.hpp"
#include "engine/trees/built_tree.hpp"
#include "engine/trees/tree_settings.hpp"

namespace impetus::inline trees {

/// One test of mixed volumes, 12 to 29 units as measured, over one of blocks of spheres, .15 to .4.
inline constexpr double kMixedTestCost = 60.0;

/// A tree of kind kHeterogeneous; see build_tree().
BuiltTree heterogeneous_tree(const TriangleMesh& solid, const TreeSettings& settings,
                             const Progress& progress = {});

}  // namespace impetus::inline trees
