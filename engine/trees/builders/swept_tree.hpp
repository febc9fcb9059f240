// The volume tree of a body that is itself a swept volume: what no builder need find.
//
//   [ bounding sphere ]          where asked for: a body seen whole
//   [ the volume, exact ]
//   [ level 1 of a built tree ]  where there is one
//   [ level 2 ... ]
//
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "engine/shapes/triangle_mesh.hpp"
#include "engine/trees/tree_settings.hpp"
#include "engine/trees/volume_tree.hpp"

namespace impetus::inline trees {

/// What a swept body's tree has beside the volume itself.
struct SweptLevels {
  bool sphere_first{false};  ///< level 0 is the volume's bounding sphere
  bool finer{false};         ///< below the volume: the levels of build_tree()
};

/// The settings of the finer levels: what `settings` leave when those above them are counted; none
/// when there are no finer ones, or no level is left.
std::optional<TreeSettings> finer_settings(const SweptLevels& levels, const TreeSettings& settings);

/// The tree of `solid`, a mesh inscribed in `volume`, with as many levels as `settings` have at
/// most. `finer` is the tree that build_tree() makes of finer_settings(), null when there are none;
/// its root is left out. The volume grows by what rounding asks for to hold the mesh.
VolumeTree swept_tree(const TriangleMesh& solid, const Volume& volume, const SweptLevels& levels,
                      const TreeSettings& settings, const VolumeTree* finer);

}  // namespace impetus::inline trees
