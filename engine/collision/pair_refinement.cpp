// SPDX-License-Identifier: MIT
#include "engine/collision/pair_refinement.hpp"

#include <algorithm>
#include <cassert>

#include "engine/collision/sphere_block.hpp"
#include "engine/volumes/core.hpp"

namespace impetus::inline collision {
namespace {

/// κ of the spheres about the nodes, (R_a + R_b − d) / (2 min(R_a, R_b)) in [0, 1], for it need
/// only order the pairs.
double nesting(const Sphere& a, const Sphere& b) {
  const double smaller_m = std::min(a.radius_m, b.radius_m);
  const double reach_m = a.radius_m + b.radius_m - (a.centre - b.centre).norm();
  return smaller_m > 0.0 ? std::clamp(reach_m / (2.0 * smaller_m), 0.0, 1.0) : 1.0;
}

/// By how far two cored volumes would have to move apart along `axis` (unit) to part.
double overlap_along(const CoredVolume& a, const CoredVolume& b, const Vector3& axis) {
  return a.radius_m + b.radius_m + reach_along(a.core, axis) + reach_along(b.core, axis) -
         std::abs((a.core.centre - b.core.centre).dot(axis));
}

double overlap_m(const CoredVolume& a, const CoredVolume& b) {
  const Vector3 offset = a.core.centre - b.core.centre;
  const double distance_m = offset.norm();
  double least_m = overlap_along(
      a, b, distance_m > 0.0 ? Vector3(offset / distance_m) : Vector3(Vector3::UnitX()));
  for (const Core* core : {&a.core, &b.core}) {
    for (int axis = 0; core->dimension > 0 && axis < 3; ++axis) {
      least_m = std::min(least_m, overlap_along(a, b, core->axes.col(axis)));
    }
  }
  return least_m;
}

double overlap_m(const Sphere& a, const Sphere& b) {
  return a.radius_m + b.radius_m - (a.centre - b.centre).norm();
}

}  // namespace

void PairRefinement::begin(PlacedTree& a, PlacedTree& b, int greatest_level,
                           StopReason at_greatest) {
  a_ = &a;
  b_ = &b;
  walls_ = nullptr;
  greatest_level_ = greatest_level;
  at_greatest_ = at_greatest;
  of_spheres_ = a.of_spheres() && b.of_spheres();
  deepest_level_ = std::max(a.tree().level_count(), b.tree().level_count()) - 1;
  if (of_spheres_) {
    test_roots(overlaps_of_block(a.world_lanes(0, 1), 1, b.world_lanes(0, 1), 1) != 0);
  } else {
    a.place_siblings(0, 1);
    b.place_siblings(0, 1);
    test_roots(nodes_overlap(a, 0, b, 0));
  }
}

void PairRefinement::begin(PlacedTree& a, const Enclosure& walls, int greatest_level) {
  a_ = &a;
  b_ = nullptr;
  walls_ = &walls;
  greatest_level_ = greatest_level;
  at_greatest_ = StopReason::kGreatestLevel;
  of_spheres_ = false;
  deepest_level_ = a.tree().level_count() - 1;
  a.place_siblings(0, 1);
  test_roots(node_reaches_wall(a, 0, walls));
}

void PairRefinement::test_roots(bool touch) {
  committed_.clear();
  expanding_.clear();
  level_ = 0;
  if (touch) {
    committed_.add({0, 0});
  }
  look_for_next_block();
}

std::int64_t PairRefinement::block_size(const NodePair& pair) const {
  const std::int32_t of_a = a_->tree().links(pair.a).child_count;
  const std::int32_t of_b = b_ != nullptr ? b_->tree().links(pair.b).child_count : 0;
  return of_a == 0 && of_b == 0 ? 0
                                : static_cast<std::int64_t>(std::max(of_a, 1)) * std::max(of_b, 1);
}

std::int64_t PairRefinement::most_found_after_next_block() const {
  // What the block finds, and the pairs of leaves behind it, which are carried over untested.
  std::int64_t leaf_pairs = 0;
  for (NodePairs::Place place = committed_.after(next_);
       !committed_.is_end(place) && block_size(committed_.at(place)) == 0;
       place = committed_.after(place)) {
    ++leaf_pairs;
  }
  return found_so_far() + next_block() + leaf_pairs;
}

std::int64_t PairRefinement::tests_of_next_level() const {
  std::int64_t tests = 0;
  for (NodePairs::Place place = next_; !committed_.is_end(place); place = committed_.after(place)) {
    tests += block_size(committed_.at(place));
  }
  return tests;
}

double PairRefinement::fit_error_m(int level) const {
  return a_->tree().fit_error_m(level) + (b_ != nullptr ? b_->tree().fit_error_m(level) : 0.0);
}

void PairRefinement::refine_one_block() {
  assert(!resolved());
  expand(committed_.at(next_));
  next_ = committed_.after(next_);
  pass_leaf_pairs();
  if (committed_.is_end(next_)) {
    commit();
  }
}

void PairRefinement::expand(const NodePair& pair) {
  if (of_spheres()) {
    for_each_block_below(*a_, *b_, pair, [this](const SphereBlock& block) {
      expanding_.add_block(block.first,
                           overlaps_of_block(block.a, block.rows, block.b, block.columns));
    });
    return;
  }
  const NodeLinks of_a = one_level_deeper(a_->tree(), pair.a);
  const NodeLinks of_b =
      b_ != nullptr ? one_level_deeper(b_->tree(), pair.b) : NodeLinks{pair.b, 1};  // of the walls
  a_->place_siblings(of_a.first_child, of_a.child_count);
  if (b_ != nullptr) {
    b_->place_siblings(of_b.first_child, of_b.child_count);
  }
  for (std::int32_t i = of_a.first_child; i < of_a.first_child + of_a.child_count; ++i) {
    for (std::int32_t j = of_b.first_child; j < of_b.first_child + of_b.child_count; ++j) {
      if (b_ != nullptr ? nodes_overlap(*a_, i, *b_, j) : node_reaches_wall(*a_, i, *walls_)) {
        expanding_.add({i, j});
      }
    }
  }
}

/// Leaf pairs cost nothing and stay as they are.
void PairRefinement::pass_leaf_pairs() {
  next_block_ = 0;
  for (; !committed_.is_end(next_); next_ = committed_.after(next_)) {
    const NodePair pair = committed_.at(next_);
    next_block_ = block_size(pair);
    if (next_block_ > 0) {
      return;
    }
    expanding_.add(pair);
  }
}

void PairRefinement::commit() {
  committed_.swap(expanding_);
  expanding_.clear();
  ++level_;
  look_for_next_block();
}

/// A level of leaf pairs alone is the finest.
void PairRefinement::look_for_next_block() {
  next_ = committed_.first();
  next_block_ = 0;
  const auto has_block = [this](const NodePair& pair) { return block_size(pair) > 0; };
  if (level_ >= deepest_level_ || std::none_of(committed_.begin(), committed_.end(), has_block)) {
    next_ = committed_.past_the_end();
  } else if (level_ < greatest_level_) {
    pass_leaf_pairs();
  }
}

StopReason PairRefinement::stop_reason() const {
  if (committed_.empty()) {
    return StopReason::kSeparated;
  }
  if (!has_finer()) {
    return StopReason::kFinest;
  }
  return level_ < greatest_level_ ? StopReason::kBudgetSpent : at_greatest_;
}

// How likely it is that the surfaces of a pair meet where its nodes do.
// (Dingliana 2002, eq. 4.6)
double PairRefinement::likeliest_collision() const {
  double likeliest = 0.0;
  for (const NodePair& pair : committed_) {
    const Sphere of_a = bounding_sphere(a_->world_volume(pair.a));
    double kappa = 0.0;
    double occupancy = a_->tree().surface(pair.a).occupancy;
    if (b_ != nullptr) {
      kappa = nesting(of_a, bounding_sphere(b_->world_volume(pair.b)));
      occupancy *= b_->tree().surface(pair.b).occupancy;
    } else {
      for (int wall = 0; wall < kWallCount; ++wall) {
        const double depth_m = touch_of_wall(*a_, pair.a, *walls_, wall).depth_m;
        kappa = std::max(kappa, of_a.radius_m > 0.0
                                    ? std::clamp(depth_m / (2.0 * of_a.radius_m), 0.0, 1.0)
                                    : 1.0);
      }
    }
    likeliest = std::max(likeliest, kappa * occupancy);
  }
  return likeliest;
}

// How deep the nodes of a pair overlap, at most: cheap beside their contact, and close to its depth
// where it is little.
double PairRefinement::deepest_overlap_m() const {
  double deepest_m = 0.0;
  for (const NodePair& pair : committed_) {
    double depth_m = 0.0;
    if (of_spheres_) {
      depth_m = overlap_m(a_->world_sphere(pair.a), b_->world_sphere(pair.b));
    } else if (b_ != nullptr) {
      depth_m = overlap_m(cored(a_->world_volume(pair.a)), cored(b_->world_volume(pair.b)));
    } else {
      for (int wall = 0; wall < kWallCount; ++wall) {
        depth_m = std::max(depth_m, reach_beyond(*walls_, wall, a_->world_volume(pair.a)));
      }
    }
    deepest_m = std::max(deepest_m, depth_m);
  }
  return deepest_m;
}

}  // namespace impetus::inline collision
