// SPDX-License-Identifier: MIT
#include "engine/trees/sibling_blocks.hpp"

#include "engine/numerics/lanes.hpp"
#include "engine/trees/volume_tree.hpp"

namespace impetus::inline trees {

static_assert(kLanes == 8, "a place in a block is three bits");

SiblingBlocks::SiblingBlocks(const std::vector<NodeLinks>& links) {
  slots_.reserve(links.size());
  add_siblings(1);  // the root
  for (const NodeLinks& node : links) {
    add_siblings(node.child_count);
  }
}

void SiblingBlocks::add_siblings(std::int32_t nodes) {
  for (std::int32_t i = 0; i < nodes; ++i) {
    const auto lane = static_cast<std::uint32_t>(i % kLanes);
    count_ += lane == 0 ? 1 : 0;
    slots_.push_back((count_ - 1) << 3 | lane);
  }
}

}  // namespace impetus::inline trees
