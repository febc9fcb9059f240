// SPDX-License-Identifier: MIT
#include "experiments/trade/impacts/level_touch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "engine/collision/entry/node_gap.hpp"
#include "engine/collision/sphere_block.hpp"

namespace impetus::inline trade {
namespace {

/// From where to where of the way two volumes overlap.
struct Stretch {
  double begin_m{0.0};
  double end_m{0.0};
};

std::optional<Stretch> overlap_of(const Sphere& a, const Sphere& b, const Vector3& direction) {
  const Vector3 offset = a.centre - b.centre;
  const double reach_m = a.radius_m + b.radius_m;
  const double along_m = offset.dot(direction);
  const double square = reach_m * reach_m - (offset - along_m * direction).squaredNorm();
  if (square < 0.0) {
    return std::nullopt;
  }
  const double half_m = std::sqrt(square);
  return Stretch{-along_m - half_m, -along_m + half_m};
}

Volume moved(const Volume& volume, const Vector3& by) {
  return placed(volume, {by, Quaternion::Identity()});
}

/// Where volumes begin to overlap, from where the spheres about them do.
std::optional<double> beginning_of(const Volume& a, const Volume& b, const Vector3& direction,
                                   const Stretch& of_bounds) {
  constexpr int kMostSteps = 200;
  constexpr double kTouching = 1e-12;
  const double touching_m = kTouching * (of_bounds.end_m - of_bounds.begin_m);
  double way_m = of_bounds.begin_m;
  for (int step = 0; step < kMostSteps && way_m <= of_bounds.end_m; ++step) {
    const NodeGap gap = gap_of_nodes(moved(a, way_m * direction), b);
    if (gap.gap_m <= touching_m) {
      return way_m;
    }
    const double closing = -gap.normal.dot(direction);
    if (!(closing > 0.0)) {
      return std::nullopt;
    }
    way_m += gap.gap_m / closing;
  }
  return std::nullopt;
}

/// Finds how far body a moves until nodes of a level touch, by branch and bound over pairs of
/// nodes.
class BoundsOnTheWay {
 public:
  BoundsOnTheWay(PlacedTree& a, PlacedTree& b, const Vector3& direction, int level)
      : a_(a), b_(b), direction_(direction), level_(level) {
    a_.place_siblings(0, 1);
    b_.place_siblings(0, 1);
  }

  std::optional<double> first() {
    if (const std::optional<double> way_m = way_of({0, 0}, 0.0)) {
      descend({0, 0}, 0, *way_m);
    }
    return first_m_ < kNever ? std::optional(first_m_) : std::nullopt;
  }

 private:
  /// A pair of children, and from where on it overlaps.
  struct Below {
    NodePair nodes;
    double way_m;
  };

  /// `way_m`: from where on the pair and those above it overlap.
  void descend(const NodePair& nodes, int level, double way_m) {
    if (way_m >= first_m_) {
      return;
    }
    const NodeLinks of_a = one_level_deeper(a_.tree(), nodes.a);
    const NodeLinks of_b = one_level_deeper(b_.tree(), nodes.b);
    const bool leaves = of_a.first_child == nodes.a && of_b.first_child == nodes.b;
    if (level >= level_ || leaves) {
      first_m_ = way_m;
      return;
    }
    std::vector<Below> below;
    for (std::int32_t i = 0; i < of_a.child_count; ++i) {
      for (std::int32_t j = 0; j < of_b.child_count; ++j) {
        const NodePair pair{of_a.first_child + i, of_b.first_child + j};
        if (const std::optional<double> begin_m = way_of(pair, way_m)) {
          below.push_back({pair, *begin_m});
        }
      }
    }
    std::stable_sort(below.begin(), below.end(),
                     [](const Below& x, const Below& y) { return x.way_m < y.way_m; });
    for (const Below& pair : below) {
      descend(pair.nodes, level + 1, pair.way_m);
    }
  }

  /// Where a pair begins to overlap, not before `least_m`; none when it does not, or too late to be
  /// the first.
  std::optional<double> way_of(const NodePair& nodes, double least_m) {
    const Volume of_a = a_.world_volume(nodes.a);
    const Volume of_b = b_.world_volume(nodes.b);
    const std::optional<Stretch> bounds =
        overlap_of(bounding_sphere(of_a), bounding_sphere(of_b), direction_);
    if (!bounds || bounds->end_m < least_m || bounds->begin_m >= first_m_) {
      return std::nullopt;
    }
    if (a_.of_spheres() && b_.of_spheres()) {
      return std::max(least_m, bounds->begin_m);
    }
    if (bounds->begin_m < least_m && overlap(moved(of_a, least_m * direction_), of_b)) {
      return least_m;
    }
    const std::optional<double> begin_m = beginning_of(of_a, of_b, direction_, *bounds);
    return begin_m && *begin_m >= least_m ? begin_m : std::nullopt;
  }

  static constexpr double kNever = std::numeric_limits<double>::infinity();

  PlacedTree& a_;
  PlacedTree& b_;
  Vector3 direction_;
  int level_;
  double first_m_{kNever};
};

}  // namespace

std::optional<double> first_touch_of_bounds(PlacedTree& a, PlacedTree& b, const Vector3& direction,
                                            int level) {
  return BoundsOnTheWay(a, b, direction, level).first();
}

}  // namespace impetus::inline trade
