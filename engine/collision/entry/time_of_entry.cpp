// SPDX-License-Identifier: MIT
#include "engine/collision/entry/time_of_entry.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>

#include "engine/collision/entry/counted_pairs.hpp"
#include "engine/collision/entry/directed_speeds.hpp"
#include "engine/collision/entry/node_ways.hpp"
#include "engine/collision/entry/overlap_at_start.hpp"
#include "engine/collision/sphere_block.hpp"

namespace impetus::inline collision {
namespace {

/// Of slow_way_m: how deep bodies overlap when they are stopped, and what they may still go.
constexpr double kHairShare = 0.125;
constexpr double kRestShare = 0.25;
/// Of that depth: how much deeper bodies may overlap that did at the start.
constexpr double kDeeperShare = 0.25;
constexpr double kForever = std::numeric_limits<double>::infinity();

/// The search for the first entry of one pair, by the ways that nodes go.
template <typename Ways>
class EntrySearch {
 public:
  explicit EntrySearch(const PairOnTheWay& pair)
      : pairs_(pair),
        pair_(pairs_.pair()),
        slow_m_(slow_way_m(pair.a.tree(), pair.b.tree(), pair.greatest_level)),
        hair_m_(kHairShare * slow_m_),
        stretches_(stretches_of(pair.path_a, pair.path_b)),
        ways_(pair.path_a, pair.path_b, pair.a.reach_m(), pair.b.reach_m()) {}

  Entry run() {
    Entry entry;
    entry.time = first_time();
    entry.tests = pairs_.tests();
    entry.refused = pairs_.refused();
    return entry;
  }

 private:
  using OfPair = typename Ways::OfPair;
  using OfBlock = typename Ways::OfBlock;

  std::optional<double> first_time() {
    if (stretches_.empty()) {
      return std::nullopt;
    }
    ways_.enter(stretches_[0]);
    place(stretches_[0].begin);
    at_start_ = overlap_at_start(pairs_, slow_m_);
    if (pairs_.capped()) {
      return unless_nearly_there(stretches_[0].begin, slow_m_);
    }
    if (at_start_.any) {
      hair_m_ *= kDeeperShare;
    }
    if (at_start_.depth_m + hair_m_ > slow_m_) {
      return std::nullopt;
    }
    for (const RelativeStretch& stretch : stretches_) {
      const std::optional<double> time = first_time_in(stretch);
      if (time) {
        return pairs_.capped() ? unless_nearly_there(*time, slow_m_)
                               : unless_nearly_there(*time, 0.0);
      }
    }
    return std::nullopt;
  }

  /// None when the stretch's end is reached.
  std::optional<double> first_time_in(const RelativeStretch& stretch) {
    ways_.enter(stretch);
    double time = stretch.begin;
    while (time < stretch.end) {
      place(time);
      look_ahead(ways_.horizon(stretch.end - time));
      const double next = time + safe_;
      if (pairs_.capped() || !(next > time)) {
        return time;
      }
      time = next;
    }
    return std::nullopt;
  }

  /// Finds for how long no finest nodes can touch, at most `most`. Where the nearest come first,
  /// those that came nearest in the look before do, and of siblings the nearest: few come nearer,
  /// and the others are ruled out sooner.
  void look_ahead(double most) {
    safe_ = most;
    if (nearest_first() && nearest_ && !pairs_.capped()) {
      pairs_.count(1);
      safe_ = std::min(most, std::nextafter(time_of_last_nodes(*nearest_), kForever));
    }
    const double expected = safe_;
    bound_all();
    if (safe_ == expected && expected < most) {  // the nodes above them stay apart for longer
      safe_ = most;
      bound_all();
    }
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

  [[nodiscard]] bool nearest_first() const { return pair_.rules == EntryRules::kNearestFirst; }

  [[nodiscard]] double reach_a() const { return pair_.a.tree().bounding_radius_m(); }
  [[nodiscard]] double reach_b() const { return pair_.b.tree().bounding_radius_m(); }

  /// Lowers safe_ to the time for which no finest nodes can touch.
  void bound_all() {
    if (pairs_.capped()) {
      return;
    }
    pairs_.count(1);
    if (!pairs_.of_spheres()) {
      bound({0, 0}, 0, 0.0);
      return;
    }
    pairs_.place_roots();
    const Sphere a = pair_.a.world_sphere(0);
    const Sphere b = pair_.b.world_sphere(0);
    bound_spheres({0, 0}, a, b, ways_.of(a, b), 0, 0.0);
  }

  /// Lowers safe_ to the time for which the finest nodes below this pair cannot touch. `at_least`
  /// is what holds of the pairs above.
  void bound(const NodePair& nodes, int level, double at_least) {
    const Sphere bound_a = bounding_sphere(pair_.a.world_volume(nodes.a));
    const Sphere bound_b = bounding_sphere(pair_.b.world_volume(nodes.b));
    const OfPair way = ways_.of(bound_a, bound_b);
    double time = std::max(at_least, time_of_spheres(bound_a, bound_b, way));
    if (time < safe_) {
      time = std::max(time, time_of_nodes(nodes, way));
    }
    bound_by(nodes, level, time, way, [&] {
      pairs_.for_each_pair_below(nodes, [&](const NodePair& below) {
        if (!pairs_.capped()) {
          pairs_.count(1);
          bound(below, level + 1, time);
        }
      });
    });
  }

  /// The same of spheres, a block at a time.
  void bound_spheres(const NodePair& nodes, const Sphere& a, const Sphere& b, const OfPair& way,
                     int level, double at_least) {
    const double time = std::max(at_least, time_of_spheres(a, b, way));
    bound_by(nodes, level, time, way, [&] {
      for_each_block_below(pair_.a, pair_.b, nodes,
                           [&](const SphereBlock& block) { bound_block(block, level + 1, time); });
    });
  }

  /// `time` is what is known of the pair, `bound_below` goes on with those below it.
  template <typename BoundBelow>
  void bound_by(const NodePair& nodes, int level, double time, const OfPair& way,
                const BoundBelow& bound_below) {
    const bool last = pairs_.is_last(nodes, level);
    if (last && time <= 0.0) {
      time = std::max(time, time_of_overlap(nodes, way));
    }
    if (time >= safe_) {
      return;
    }
    if (last) {
      lower_to(time, nodes);
      return;
    }
    bound_below();
  }

  void bound_block(const SphereBlock& block, int level, double at_least) {
    if (pairs_.capped()) {
      return;
    }
    if (at_least >= safe_) {
      pairs_.count(std::int64_t{block.rows} * block.columns);
      return;
    }
    OfBlock ways;
    std::uint64_t near = ways_.within(safe_, hair_m_, block, ways);
    if (level >= pair_.greatest_level &&
        pairs_.tests() + std::int64_t{block.rows} * block.columns < pair_.most_tests) {
      bound_last_block(block, near, ways, at_least);
      return;
    }
    const auto go_on = [&](int row, int column) {
      const Sphere a = sphere_of(block.a, row);
      const Sphere b = sphere_of(block.b, column);
      const OfPair way = ways_.of(ways, block, row, column);
      if (at_least < safe_ && !ways_.apart_for(safe_, hair_m_, a, b, way)) {
        bound_spheres({block.first.a + row, block.first.b + column}, a, b, way, level, at_least);
      }
    };
    if (nearest_first() && near != 0) {
      const int nearest = nearest_of(block, near);
      go_on(nearest / kLanes, nearest % kLanes);
      near &= ~(std::uint64_t{1} << nearest);
    }
    pairs_.for_each_set(
        block, near, [] { return false; }, go_on);
  }

  /// The bit of the pair with the least gap, of those that are set; the first of equals.
  [[nodiscard]] static int nearest_of(const SphereBlock& block, std::uint64_t bits) {
    int nearest = std::countr_zero(bits);
    double least_m = kForever;
    for (; bits != 0; bits &= bits - 1) {
      const int bit = std::countr_zero(bits);
      const double gap_m =
          gap_of_bounds(sphere_of(block.a, bit / kLanes), sphere_of(block.b, bit % kLanes)).gap_m;
      if (gap_m < least_m) {
        least_m = gap_m;
        nearest = bit;
      }
    }
    return nearest;
  }

  /// The same of finest nodes, of which nothing is counted that is left.
  void bound_last_block(const SphereBlock& block, std::uint64_t near, const OfBlock& ways,
                        double at_least) {
    pairs_.count(std::int64_t{block.rows} * block.columns);
    for (; near != 0 && at_least < safe_; near &= near - 1) {
      const int bit = std::countr_zero(near);
      const int row = bit / kLanes;
      const int column = bit % kLanes;
      const Sphere a = sphere_of(block.a, row);
      const Sphere b = sphere_of(block.b, column);
      const OfPair way = ways_.of(ways, block, row, column);
      if (ways_.apart_for(safe_, hair_m_, a, b, way)) {
        continue;
      }
      const NodePair nodes{block.first.a + row, block.first.b + column};
      double time = std::max(at_least, time_of_spheres(a, b, way));
      if (time <= 0.0) {
        time = std::max(time, time_of_overlap(nodes, way));
      }
      if (!(time >= safe_)) {
        lower_to(time, nodes);
      }
    }
  }

  void lower_to(double time, const NodePair& nodes) {
    safe_ = time;
    nearest_ = nodes;
  }

  /// For how long two finest nodes cannot touch, whatever is known of those above them.
  [[nodiscard]] double time_of_last_nodes(const NodePair& nodes) {
    const Sphere a = bounding_sphere(pair_.a.world_volume(nodes.a));
    const Sphere b = bounding_sphere(pair_.b.world_volume(nodes.b));
    const OfPair way = ways_.of(a, b);
    const double time =
        pairs_.of_spheres() ? time_of_spheres(a, b, way) : time_of_nodes(nodes, way);
    return time > 0.0 ? time : std::max(time, time_of_overlap(nodes, way));
  }

  /// For how long spheres do not overlap by more than a hair; 0 when they overlap now.
  [[nodiscard]] double time_of_spheres(const Sphere& a, const Sphere& b, const OfPair& way) const {
    const NodeGap now = gap_of_bounds(a, b);
    return now.gap_m > 0.0 ? ways_.time_of_spheres(now.gap_m + hair_m_, now, way, safe_) : 0.0;
  }

  /// The same of nodes that are not spheres.
  [[nodiscard]] double time_of_nodes(const NodePair& nodes, const OfPair& way) const {
    const NodeGap now = pairs_.gap_of(nodes);
    return now.gap_m > 0.0 ? ways_.time_of_nodes(now.gap_m + hair_m_, now, way, safe_) : 0.0;
  }

  /// The same of finest nodes that seem to overlap: they may, as deep as at the start.
  [[nodiscard]] double time_of_overlap(const NodePair& nodes, const OfPair& way) const {
    const NodeGap now = pairs_.gap_of(nodes);
    const double deeper_m = std::max(0.0, -now.gap_m) - at_start_.depth_m;
    const double too_deep_m = at_start_.any ? 0.5 * hair_m_ : 0.0;
    if (deeper_m >= too_deep_m && nodes_overlap(pair_.a, nodes.a, pair_.b, nodes.b)) {
      return 0.0;
    }
    const double way_m = hair_m_ - deeper_m;
    return pairs_.of_spheres() ? ways_.time_of_spheres(way_m, now, way, safe_)
                               : ways_.time_of_nodes(way_m, now, way, safe_);
  }

  CountedPairs pairs_;
  const PairOnTheWay& pair_;
  double slow_m_;
  double hair_m_;
  Stretches stretches_;
  Ways ways_;
  OverlapAtStart at_start_;
  double safe_{0.0};
  std::optional<NodePair> nearest_;  ///< finest nodes, in the last look at all
};

}  // namespace

bool is_fast(const PairOnTheWay& pair, double share_of_slow_way) {
  const double way_m =
      way_from(0.0, stretches_of(pair.path_a, pair.path_b), pair.a.tree().bounding_radius_m(),
               pair.b.tree().bounding_radius_m());
  const double slow_m = slow_way_m(pair.a.tree(), pair.b.tree(), pair.greatest_level);
  return slow_m > 0.0 && way_m > share_of_slow_way * slow_m;
}

Entry time_of_entry(const PairOnTheWay& pair) {
  return pair.rules == EntryRules::kNodeWays ? EntrySearch<NodeWays>(pair).run()
                                             : EntrySearch<DirectedSpeeds>(pair).run();
}

}  // namespace impetus::inline collision
