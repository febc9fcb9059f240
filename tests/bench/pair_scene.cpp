// SPDX-License-Identifier: MIT
#include "tests/bench/pair_scene.hpp"

#include <cstdio>

#include "engine/collision/contact_model.hpp"
#include "tests/bench/descent_limit.hpp"
#include "tests/bench/pair_poses.hpp"
#include "tests/bench/thread_time.hpp"
#include "tests/engine/once.hpp"

namespace impetus {
namespace {

constexpr int kPoses = 2'000;
constexpr int kSweeps = 5;

/// What one pose costs, and what is found there.
struct PoseCost {
  double descent_us{0.0};   ///< all overlapping leaves; median of the sweeps
  double contacts_us{0.0};  ///< and the contacts that they are reduced to
  std::int64_t tests{0};
  std::size_t overlapping{0};
};

class PairOfTrees {
 public:
  explicit PairOfTrees(const VolumeTree& tree) : a_(tree), b_(tree) {}

  /// Refined as far as it goes, in the order of a step: both are moved first. Valid until the next.
  const PairRefinement& refined_at(const Pose& pose) {
    begin_at(pose);
    while (!refinement_.resolved()) {
      refinement_.refine_one_block();
    }
    return refinement_;
  }

  std::vector<Contact> contacts(const PairRefinement& refinement) {
    return refinement.overlapping().empty()
               ? std::vector<Contact>{}
               : pair_contacts({0, 1}, refinement, {a_}, {b_}, {}, ContactModel{});
  }

  std::int64_t tests_at(const Pose& pose) {
    begin_at(pose);
    std::int64_t tests = 1;
    while (!refinement_.resolved()) {
      tests += refinement_.next_block();
      refinement_.refine_one_block();
    }
    return tests;
  }

 private:
  void begin_at(const Pose& pose) {
    a_.move_to({});
    b_.move_to(pose);
    refinement_.begin(a_, b_);
  }

  PairRefinement refinement_;
  PlacedTree a_;
  PlacedTree b_;
};

/// All poses in turn, several times over, so that no pose finds the caches warm from itself.
std::vector<PoseCost> costs_of(const VolumeTree& tree, const std::vector<PairPose>& poses) {
  PairOfTrees trees(tree);
  const double looking_ns = clock_cost_ns();
  std::vector<std::vector<double>> descents_us(poses.size());
  std::vector<std::vector<double>> contacts_us(poses.size());
  std::vector<PoseCost> costs(poses.size());
  const auto since_us = [&](std::int64_t start_ns) {
    return (static_cast<double>(thread_cpu_ns() - start_ns) - looking_ns) * 1e-3;
  };
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    for (std::size_t i = 0; i < poses.size(); ++i) {
      const std::int64_t start_ns = thread_cpu_ns();
      const PairRefinement& refinement = trees.refined_at(poses[i].b);
      descents_us[i].push_back(since_us(start_ns));
      const std::int64_t model_ns = thread_cpu_ns();
      costs[i].overlapping = refinement.overlapping().size();
      static_cast<void>(trees.contacts(refinement));
      contacts_us[i].push_back(since_us(model_ns));
    }
  }
  for (std::size_t i = 0; i < poses.size(); ++i) {
    costs[i].descent_us = spread_of(std::move(descents_us[i])).median;
    costs[i].contacts_us = spread_of(std::move(contacts_us[i])).median;
    costs[i].tests = trees.tests_at(poses[i].b);
  }
  return costs;
}

/// Over the poses at which leaves overlap.
struct PairSummary {
  Spread descent_us;
  Spread with_contacts_us;
  Spread tests;
  Spread overlapping;
  int hits{0};
  int false_hits{0};
  int missed{0};
  double tests_per_s{0.0};
};

PairSummary summary_of(const std::vector<PoseCost>& costs, const std::vector<PairPose>& poses) {
  PairSummary summary;
  std::vector<double> descent_us;
  std::vector<double> with_contacts_us;
  std::vector<double> tests;
  std::vector<double> overlapping;
  for (std::size_t i = 0; i < costs.size(); ++i) {
    const bool hit = costs[i].overlapping > 0;
    summary.false_hits += hit && !poses[i].surfaces_cross ? 1 : 0;
    summary.missed += !hit && poses[i].surfaces_cross ? 1 : 0;
    if (hit) {
      ++summary.hits;
      descent_us.push_back(costs[i].descent_us);
      with_contacts_us.push_back(costs[i].descent_us + costs[i].contacts_us);
      tests.push_back(static_cast<double>(costs[i].tests));
      overlapping.push_back(static_cast<double>(costs[i].overlapping));
    }
  }
  summary.descent_us = spread_of(std::move(descent_us));
  summary.with_contacts_us = spread_of(std::move(with_contacts_us));
  summary.tests = spread_of(std::move(tests));
  summary.overlapping = spread_of(std::move(overlapping));
  summary.tests_per_s = summary.tests.mean / (summary.descent_us.mean * 1e-6);
  return summary;
}

int crossing(const std::vector<PairPose>& poses) {
  int count = 0;
  for (const PairPose& pose : poses) {
    count += pose.surfaces_cross ? 1 : 0;
  }
  return count;
}

}  // namespace

void print_pair(const CrowdShape& shape, const BenchOptions& options) {
  const auto poses = random_pair_poses(shape.mesh, options.count_of(kPoses));
  std::printf("\ntwo bodies at %zu random poses; surfaces cross at %d\n", poses.size(),
              crossing(poses));
  const double limit = limit_pairs_per_s();
  std::printf("  limit of the machine (8 x 8 blocks, AVX2, single precision): %.2e pairs/s\n",
              limit);
  for (const auto& tree : {shape.coarse, shape.fine}) {
    const PairSummary found = summary_of(costs_of(*tree, poses), poses);
    std::printf("  %4d leaves: descent where they hit %6.2f us median, %.2f p99, %.2f longest%s\n",
                leaf_count(*tree), found.descent_us.median, found.descent_us.p99,
                found.descent_us.longest, tree == shape.fine ? "   goal: 3" : "");
    std::printf("               with contacts, reduced    %6.2f us median, %.2f p99\n",
                found.with_contacts_us.median, found.with_contacts_us.p99);
    std::printf("               hits %d, false %d, missed %d%s\n", found.hits, found.false_hits,
                found.missed, tree == shape.fine ? "   goal: 70 of 771 false, 0 missed" : "");
    std::printf("               tests %.0f median, overlapping leaves %.0f median\n",
                found.tests.median, found.overlapping.median);
    std::printf("               %.2e tests/s, %.3f of the limit%s\n", found.tests_per_s,
                limit > 0.0 ? found.tests_per_s / limit : 0.0,
                tree == shape.fine ? "   goal: .25" : "");
    std::fflush(stdout);
  }
}

}  // namespace impetus
