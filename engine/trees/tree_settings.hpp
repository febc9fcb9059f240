// What kind of volume tree to build, how deep and how wide, and what every builder asks of a mesh.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "engine/shapes/triangle_mesh.hpp"

namespace impetus::inline trees {

/// octree         spheres round the cubes of an octree: fast and simple
/// medial         spheres near the medial axis: tight
/// voxel          cubes of a regular grid, their places implicit
/// box            oriented boxes
/// swept          spheres swept along a point, a segment or a rectangle, whichever fits best
/// heterogeneous  for each node the volume that fits best for its cost, or all medial spheres
enum class TreeKind { kOctree, kMedial, kVoxel, kBox, kSwept, kHeterogeneous };

inline constexpr int kGreatestTreeDepth = 8;
inline constexpr int kLeastBranching = 2;
inline constexpr int kGreatestBranching = 64;

/// What is asked of a builder.
struct TreeSettings {
  TreeKind kind{TreeKind::kOctree};
  int depth{4};      ///< levels beyond the root, at most; see kGreatestTreeDepth
  int branching{8};  ///< children of a node, at most; voxels take a cube of a whole number
  /// Levels beyond the root that are built, for whoever reaches no deeper: those are as they are in
  /// the whole tree, where the last of them has children.
  int built_depth{kGreatestTreeDepth};

  friend bool operator==(const TreeSettings&, const TreeSettings&) = default;
};

/// How many levels beyond the root a builder makes, at most.
int levels_to_build(const TreeSettings& settings);

/// The kind's name in files and on the command line, such as "octree".
std::string name_of(TreeKind kind);

/// The names of all kinds, in the order of the enum.
const std::vector<std::string>& tree_kind_names();

/// The kind of a name. Throws std::invalid_argument that lists the names when there is none.
TreeKind tree_kind(const std::string& name);

/// What is wrong with the settings, in words; empty when nothing is.
std::string problem_of(const TreeSettings& settings);

/// Called between pieces of work with the share that is done, from 0 to 1. It may throw, which
/// abandons the work.
using Progress = std::function<void(double share)>;

/// Throws std::invalid_argument in the name of `builder` unless `mesh` is closed, faces outward and
/// encloses more than rounding may have left of nothing: 1e-12 of its bounding cube.
void require_solid(const TriangleMesh& mesh, const std::string& builder);

/// Throws std::invalid_argument where problem_of(settings) is not empty or `mesh` is no solid.
void require_buildable(const TriangleMesh& mesh, const TreeSettings& settings);

}  // namespace impetus::inline trees
