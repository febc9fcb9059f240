// SPDX-License-Identifier: MIT
#include "experiments/trade/crowds/pair_levels.hpp"

#include <array>
#include <optional>

#include "engine/collision/broad_phase.hpp"
#include "engine/collision/work_ledger.hpp"
#include "engine/numerics/at.hpp"
#include "engine/scheduling/eccentricity_metric.hpp"
#include "engine/scheduling/gap_metrics.hpp"
#include "experiments/run/collision_truth.hpp"

namespace impetus::inline trade {
namespace {

/// The bodies of one step, and what of their collisions shows.
class StepPairs {
 public:
  StepPairs(const StagedScene& scene, const std::vector<Pose>& poses, const Look& look)
      : scene_(scene), poses_(poses), look_(look) {
    for (std::size_t body = 0; body < poses.size(); ++body) {
      placed_.emplace_back(*scene.world.models()[body].tree);
      placed_.back().move_to(poses[body]);
    }
  }

  std::vector<PairLevels> all() {
    std::vector<PairLevels> pairs;
    std::vector<MovedBound> bounds;
    for (std::size_t body = 0; body < poses_.size(); ++body) {
      bounds.push_back({bound_of(body), 0.0, scene_.world.models()[body].inverse_mass > 0.0});
    }
    for (const PairBounds& pair : candidate_pairs(bounds)) {
      add(pair, pairs);
    }
    if (scene_.world.settings().enclosure) {
      for (std::size_t body = 0; body < poses_.size(); ++body) {
        if (bounds[body].movable) {
          add({{static_cast<std::int32_t>(body), kEnclosure}, bound_of(body), bound_of(body)},
              pairs);
        }
      }
    }
    return pairs;
  }

 private:
  [[nodiscard]] Sphere bound_of(std::size_t body) const {
    return {poses_[body].position, scene_.world.models()[body].tree->bounding_radius_m()};
  }

  [[nodiscard]] const std::optional<Enclosure>& walls() const {
    return scene_.world.settings().enclosure;
  }

  void add(const PairBounds& bounds, std::vector<PairLevels>& pairs) {
    RefinedPair pair;
    pair.bodies = bounds.pair;
    PlacedTree& a = placed_[at(bounds.pair.a)];
    if (is_wall(bounds.pair.b)) {
      pair.refinement.begin(a, *walls());
    } else {
      pair.refinement.begin(a, placed_[at(bounds.pair.b)]);
    }
    if (!pair.refinement.overlapping().empty()) {
      pairs.push_back({bounds.pair, levels_of(pair, bounds)});
    }
  }

  std::vector<PairAtLevel> levels_of(RefinedPair& pair, const PairBounds& bounds) {
    const WorldSettings& settings = scene_.world.settings();
    const PhaseCosts costs(settings.costs, settings.contacts);
    const Gaps gaps = gaps_of(bounds.pair);
    std::vector<PairAtLevel> levels{{0, left_at(pair, bounds, gaps)}};
    std::int64_t tests = 0;
    while (!pair.refinement.resolved()) {
      tests += pair.refinement.next_block();
      pair.refinement.refine_one_block();
      if (pair.refinement.level() == static_cast<int>(levels.size())) {
        levels.push_back({costs.of_tests(pair, tests), left_at(pair, bounds, gaps)});
      }
    }
    return levels;
  }

  /// What shows of each wall's gap; of two bodies' in the first place.
  using Gaps = std::array<double, kWallCount>;

  Gaps gaps_of(BodyPair bodies) const {
    Gaps gaps{};
    const std::size_t a = at(bodies.a);
    const PairBounds bounds{bodies, bound_of(a), bound_of(is_wall(bodies.b) ? a : at(bodies.b))};
    const double acuity = acuity_at(bounds);
    if (!is_wall(bodies.b)) {
      const std::size_t b = at(bodies.b);
      gaps[0] = acuity *
                measure_truth(scene_.looks[a], poses_[a], scene_.looks[b], poses_[b], look_.viewer)
                    .visible_arcmin();
      return gaps;
    }
    for (int wall = 0; wall < kWallCount; ++wall) {
      if (reach_beyond(*walls(), wall, bound_of(a)) >= 0.0) {
        gaps[static_cast<std::size_t>(wall)] =
            acuity * measure_wall_truth(scene_.looks[a], poses_[a], *walls(), wall, look_.viewer)
                         .visible_arcmin();
      }
    }
    return gaps;
  }

  [[nodiscard]] double acuity_at(const PairBounds& bounds) const {
    return relative_acuity(eccentricity_deg(bounds, look_.viewer, look_.fixation, std::nullopt));
  }

  VisibleError left_at(const RefinedPair& pair, const PairBounds& bounds, const Gaps& gaps) {
    const PairRefinement& refinement = pair.refinement;
    VisibleError left;
    if (refinement.overlapping().empty()) {
      return left;
    }
    const double bound = kArcminPerDegree * acuity_at(bounds) *
                         spanned_by_length_deg(refinement.fit_error_m(refinement.level()),
                                               collision_place(bounds), look_.viewer);
    if (!is_wall(bounds.pair.b)) {
      return {gaps[0], bound};
    }
    for (int wall = 0; wall < kWallCount; ++wall) {
      if (reaches(pair, wall)) {
        left.gap += gaps[static_cast<std::size_t>(wall)];
        left.bound += bound;
      }
    }
    return left;
  }

  /// Whether a node that reaches the enclosure touches this wall of it.
  bool reaches(const RefinedPair& pair, int wall) {
    PlacedTree& tree = placed_[at(pair.bodies.a)];
    for (const NodePair& nodes : pair.refinement.overlapping()) {
      if (touch_of_wall(tree, nodes.a, *walls(), wall).depth_m >= 0.0) {
        return true;
      }
    }
    return false;
  }

  const StagedScene& scene_;
  const std::vector<Pose>& poses_;
  const Look& look_;
  std::vector<PlacedTree> placed_;
};

}  // namespace

std::vector<PairLevels> pair_levels(const StagedScene& scene, const std::vector<Pose>& poses,
                                    const Look& look) {
  return StepPairs(scene, poses, look).all();
}

}  // namespace impetus::inline trade
