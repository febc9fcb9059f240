// SPDX-License-Identifier: MIT
#include "engine/collision/entry/overlap_at_start.hpp"

#include <algorithm>
#include <cstdint>

namespace impetus::inline collision {
namespace {

/// Goes down the nodes that overlap.
class DepthSearch {
 public:
  DepthSearch(CountedPairs& pairs, double enough_m) : pairs_(pairs), enough_m_(enough_m) {}

  OverlapAtStart run() {
    if (pairs_.of_spheres()) {
      pairs_.place_roots();
    }
    if (pairs_.capped()) {
      return found_;
    }
    pairs_.count(1);
    if (overlap({0, 0})) {
      measure_depth(NodePair{0, 0}, 0);
    }
    return found_;
  }

 private:
  [[nodiscard]] bool overlap(const NodePair& nodes) const {
    return nodes_overlap(pairs_.pair().a, nodes.a, pairs_.pair().b, nodes.b);
  }

  [[nodiscard]] bool deep_enough() const { return found_.depth_m > enough_m_; }

  /// Of nodes that overlap.
  void measure_depth(const NodePair& nodes, int level) {
    if (pairs_.is_last(nodes, level)) {
      found_.any = true;
      found_.depth_m = std::max(found_.depth_m, -pairs_.gap_of(nodes).gap_m);
    } else if (pairs_.of_spheres()) {
      for_each_block_below(pairs_.pair().a, pairs_.pair().b, nodes,
                           [&](const SphereBlock& block) { measure_depth(block, level + 1); });
    } else {
      pairs_.for_each_pair_below(nodes, [&](const NodePair& below) {
        if (!pairs_.capped() && !deep_enough()) {
          pairs_.count(1);
          if (overlap(below)) {
            measure_depth(below, level + 1);
          }
        }
      });
    }
  }

  void measure_depth(const SphereBlock& block, int level) {
    if (pairs_.capped() || deep_enough()) {
      return;
    }
    const std::uint64_t overlapping =
        overlaps_of_block(block.a, block.rows, block.b, block.columns);
    pairs_.for_each_set(
        block, overlapping, [&] { return deep_enough(); },
        [&](int row, int column) {
          measure_depth(NodePair{block.first.a + row, block.first.b + column}, level);
        });
  }

  CountedPairs& pairs_;
  double enough_m_;
  OverlapAtStart found_;
};

}  // namespace

OverlapAtStart overlap_at_start(CountedPairs& pairs, double enough_m) {
  return DepthSearch(pairs, enough_m).run();
}

}  // namespace impetus::inline collision
