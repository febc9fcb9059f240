// How a volume tree is shown: its level, what colours mean, and the numbers beside it.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>
#include <vector>

#include "engine/trees/level_quality.hpp"
#include "experiments/drawing/volume_painter.hpp"

namespace impetus::inline drawing {

/// A tree and the mesh it bounds, in one frame, in metres.
struct ShownTree {
  std::string title;  ///< "dragon.obj · medial, depth 4, branching 8"
  TriangleMesh mesh;
  VolumeTree tree;
  std::vector<LevelQuality> quality;  ///< one per level; empty: not known
};

enum class TreeColour { kLevel, kOccupancy, kGroup };

struct TreeLook {
  int level{0};
  TreeColour colour{TreeColour::kLevel};
  bool volumes{true};
  bool mesh{true};  ///< seen through the volumes, which are clear then

  friend bool operator==(const TreeLook&, const TreeLook&) = default;
};

/// A node's colour (sRGB, 0–1).
std::array<float, 3> colour_of(const VolumeTree& tree, std::int32_t node, TreeColour colour);

/// The nodes that stand for the object at the look's level, in the tree's frame.
std::vector<ColouredVolume> volumes_of(const VolumeTree& tree, const TreeLook& look);

struct LegendLine {
  std::string name;
  std::string value;
};

/// A level in numbers: those that are known.
std::vector<LegendLine> legend_of(const ShownTree& shown, int level);

}  // namespace impetus::inline drawing
