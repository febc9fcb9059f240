// The search for an entry as its description reads: one node pair at a time, nothing skipped. What
// the engine's search must agree with to the last bit, the number of tests included.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <optional>

#include "engine/collision/entry/directed_speeds.hpp"
#include "engine/collision/entry/node_ways.hpp"
#include "engine/collision/entry/time_of_entry.hpp"
#include "engine/collision/pair_refinement.hpp"

namespace impetus::plain {

/// Of slow_way_m: how deep bodies overlap when they are stopped, and what they may still go.
inline constexpr double kHairShare = 0.125;
inline constexpr double kRestShare = 0.25;
/// Of that depth: how much deeper bodies may overlap that did at the start.
inline constexpr double kDeeperShare = 0.25;

template <typename Ways>
class EntrySearch {
 public:
  explicit EntrySearch(const PairOnTheWay& pair)
      : pair_(pair),
        of_spheres_(pair.a.of_spheres() && pair.b.of_spheres()),
        slow_m_(slow_way_m(pair.a.tree(), pair.b.tree(), pair.greatest_level)),
        hair_m_(kHairShare * slow_m_),
        stretches_(stretches_of(pair.path_a, pair.path_b)),
        ways_(pair.path_a, pair.path_b, pair.a.reach_m(), pair.b.reach_m()) {}

  Entry run() {
    Entry entry;
    entry.time = first_time();
    entry.tests = tests_;
    return entry;
  }

 private:
  using OfPair = typename Ways::OfPair;

  std::optional<double> first_time() {
    if (stretches_.empty()) {
      return std::nullopt;
    }
    ways_.enter(stretches_[0]);
    place(stretches_[0].begin);
    measure_depth({0, 0}, 0);
    if (capped()) {
      return unless_nearly_there(stretches_[0].begin, slow_m_);
    }
    if (overlapped_at_start_) {
      hair_m_ *= kDeeperShare;
    }
    if (allowed_depth_m_ + hair_m_ > slow_m_) {
      return std::nullopt;
    }
    for (const RelativeStretch& stretch : stretches_) {
      ways_.enter(stretch);
      const std::optional<double> time = first_time_in(stretch);
      if (time) {
        return capped() ? unless_nearly_there(*time, slow_m_) : unless_nearly_there(*time, 0.0);
      }
    }
    return std::nullopt;
  }

  /// None when the stretch's end is reached.
  std::optional<double> first_time_in(const RelativeStretch& stretch) {
    double time = stretch.begin;
    while (time < stretch.end) {
      place(time);
      safe_ = ways_.horizon(stretch.end - time);
      bound({0, 0}, 0, 0.0);
      const double next = time + safe_;
      if (capped() || !(next > time)) {
        return time;
      }
      time = next;
    }
    return std::nullopt;
  }

  /// `time` and what takes the bodies by `more_m` further; none when little is left after it.
  [[nodiscard]] std::optional<double> unless_nearly_there(double time, double more_m) const {
    const auto left_m = [&](double from) {
      return way_from(from, stretches_, reach_a(), reach_b());
    };
    for (const RelativeStretch& stretch : stretches_) {
      const double here = std::max(time, stretch.begin);
      const double speed_m = stretch.fastest(reach_a(), reach_b());
      if (here < stretch.end && more_m > 0.0 && speed_m > 0.0) {
        const double share = std::min(stretch.end - here, more_m / speed_m);
        time = here + share;
        more_m -= share * speed_m;
      }
    }
    return left_m(time) > kRestShare * slow_m_ ? std::optional(time) : std::nullopt;
  }

  void place(double time) {
    pair_.a.move_to(pose_at(pair_.path_a, time));
    pair_.b.move_to(pose_at(pair_.path_b, time));
    ways_.place(pair_.a.pose(), pair_.b.pose(), time);
  }

  [[nodiscard]] double reach_a() const { return pair_.a.tree().bounding_radius_m(); }
  [[nodiscard]] double reach_b() const { return pair_.b.tree().bounding_radius_m(); }
  [[nodiscard]] bool capped() const { return tests_ >= pair_.most_tests; }

  [[nodiscard]] bool is_last(const NodePair& nodes, int level) const {
    return level >= pair_.greatest_level || (pair_.a.tree().links(nodes.a).child_count == 0 &&
                                             pair_.b.tree().links(nodes.b).child_count == 0);
  }

  template <typename Visit>
  void for_each_pair_below(const NodePair& nodes, const Visit& visit) const {
    const NodeLinks of_a = one_level_deeper(pair_.a.tree(), nodes.a);
    const NodeLinks of_b = one_level_deeper(pair_.b.tree(), nodes.b);
    for (std::int32_t i = 0; i < of_a.child_count; ++i) {
      for (std::int32_t j = 0; j < of_b.child_count; ++j) {
        visit(NodePair{of_a.first_child + i, of_b.first_child + j});
      }
    }
  }

  /// Finds how deep the finest nodes overlap; deeper than the bodies are thick is deep enough.
  void measure_depth(const NodePair& nodes, int level) {
    if (capped() || allowed_depth_m_ > slow_m_) {
      return;
    }
    ++tests_;
    if (!nodes_overlap(pair_.a, nodes.a, pair_.b, nodes.b)) {
      return;
    }
    if (is_last(nodes, level)) {
      overlapped_at_start_ = true;
      allowed_depth_m_ = std::max(allowed_depth_m_, -gap_of(nodes).gap_m);
      return;
    }
    for_each_pair_below(nodes, [&](const NodePair& below) { measure_depth(below, level + 1); });
  }

  /// Lowers safe_ to the time for which the finest nodes below this pair cannot touch. `at_least`
  /// is what holds of the pairs above.
  void bound(const NodePair& nodes, int level, double at_least) {
    if (capped()) {
      return;
    }
    ++tests_;
    const bool last = is_last(nodes, level);
    const Sphere bound_a = bound_of(pair_.a, nodes.a);
    const Sphere bound_b = bound_of(pair_.b, nodes.b);
    const OfPair way = ways_.of(bound_a, bound_b);
    double time = std::max(at_least, time_of_spheres(bound_a, bound_b, way));
    if (!of_spheres_ && time < safe_) {
      time = std::max(time, time_of_nodes(nodes, way));
    }
    if (last && time <= 0.0) {
      time = std::max(time, time_of_overlap(nodes, way));
    }
    if (time >= safe_) {
      return;
    }
    if (last) {
      safe_ = time;
      return;
    }
    for_each_pair_below(nodes, [&](const NodePair& below) { bound(below, level + 1, time); });
  }

  /// For how long they do not overlap by more than a hair; 0 when they overlap now.
  [[nodiscard]] double time_of_spheres(const Sphere& a, const Sphere& b, const OfPair& way) const {
    const NodeGap now = gap_of_bounds(a, b);
    return now.gap_m > 0.0 ? ways_.time_of_spheres(now.gap_m + hair_m_, now, way, safe_) : 0.0;
  }

  [[nodiscard]] double time_of_nodes(const NodePair& nodes, const OfPair& way) const {
    const NodeGap now = gap_of(nodes);
    return now.gap_m > 0.0 ? ways_.time_of_nodes(now.gap_m + hair_m_, now, way, safe_) : 0.0;
  }

  /// The same of finest nodes that seem to overlap: they may, as deep as at the start.
  [[nodiscard]] double time_of_overlap(const NodePair& nodes, const OfPair& way) const {
    const NodeGap now = gap_of(nodes);
    const double deeper_m = std::max(0.0, -now.gap_m) - allowed_depth_m_;
    const double too_deep_m = overlapped_at_start_ ? 0.5 * hair_m_ : 0.0;
    if (deeper_m >= too_deep_m && nodes_overlap(pair_.a, nodes.a, pair_.b, nodes.b)) {
      return 0.0;
    }
    const double way_m = hair_m_ - deeper_m;
    return of_spheres_ ? ways_.time_of_spheres(way_m, now, way, safe_)
                       : ways_.time_of_nodes(way_m, now, way, safe_);
  }

  static Sphere bound_of(PlacedTree& tree, std::int32_t node) {
    return tree.of_spheres() ? tree.world_sphere(node) : bounding_sphere(tree.world_volume(node));
  }

  [[nodiscard]] NodeGap gap_of(const NodePair& nodes) const {
    return of_spheres_ ? gap_of_bounds(pair_.a.world_sphere(nodes.a), pair_.b.world_sphere(nodes.b))
                       : gap_of_nodes(pair_.a.world_volume(nodes.a), pair_.b.world_volume(nodes.b));
  }

  PairOnTheWay pair_;
  bool of_spheres_;
  double slow_m_;
  double hair_m_;
  Stretches stretches_;
  Ways ways_;
  bool overlapped_at_start_{false};
  double allowed_depth_m_{0.0};  ///< the depth of overlap at the start
  double safe_{0.0};
  std::int64_t tests_{0};
};

/// By the rules of today, or of recording formats below 7.
inline Entry time_of_entry(const PairOnTheWay& pair) {
  return pair.rules == EntryRules::kNodeWays ? EntrySearch<NodeWays>(pair).run()
                                             : EntrySearch<DirectedSpeeds>(pair).run();
}

}  // namespace impetus::plain
