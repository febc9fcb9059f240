// Crowds squeezed together: many small bodies of trees of every kind, in a cube too small for them.
// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <memory>
#include <utility>
#include <vector>

#include "engine/scheduling/metrics.hpp"
#include "engine/trees/builders/build_tree.hpp"
#include "tests/engine/builders.hpp"

namespace impetus {

/// The tree with each sphere replaced by a volume that holds it: kinds 0 to 3 are boxes, line-swept
/// and rectangle-swept spheres, and all of them in turn. Quick to make, where builders take
/// seconds.
inline VolumeTree wrapped(const VolumeTree& spheres, int kind) {
  std::vector<VolumeNode> nodes;
  for (std::int32_t i = 0; i < spheres.node_count(); ++i) {
    const auto sphere = std::get<Sphere>(spheres.volume(i));
    const double r = sphere.radius_m;
    const Vector3 u(0.1 * r, 0.0, 0.0);
    const std::array<Volume, 4> kinds{
        Box{sphere.centre, Vector3(r, r, r), Quaternion::Identity()},
        LineSwept{sphere.centre, u, r},
        RectangleSwept{sphere.centre, u, Vector3(0.0, 0.1 * r, 0.0), r}, sphere};
    const auto which = static_cast<std::size_t>(kind < 3 ? kind : i % 4);
    const NodeLinks& links = spheres.links(i);
    nodes.push_back({kinds[which], links.first_child, links.child_count, spheres.surface(i)});
  }
  std::vector<std::int32_t> starts;
  for (int level = 0; level < spheres.level_count(); ++level) {
    starts.push_back(spheres.level_begin(level));
  }
  return {nodes, starts};
}

/// Small L-blocks with trees of three levels: spheres, voxels and the wrapped kinds.
inline std::vector<BodyModel> bodies_of_every_tree_kind() {
  const TriangleMesh mesh = about_centre_of_mass(l_block_mesh(0.1, 0.04));
  const VolumeTree spheres = octree(mesh, 2);
  std::vector<VolumeTree> trees{spheres, build_tree(mesh, {TreeKind::kVoxel, 2, 8})};
  for (int kind = 0; kind < 4; ++kind) {
    trees.push_back(wrapped(spheres, kind));
  }
  std::vector<BodyModel> models;
  for (VolumeTree& tree : trees) {
    BodyModel model = solid_body(mesh, /*depth=*/0);
    model.tree = std::make_shared<VolumeTree>(std::move(tree));
    models.push_back(std::move(model));
  }
  return models;
}

/// `count` of `kinds` in turn, at random in a cube of half edge `half_edge_m`, flying and spinning.
inline World squeezed_crowd(RandomStream& random, const std::vector<BodyModel>& kinds, int count,
                            double half_edge_m, WorldSettings settings) {
  std::vector<BodyModel> models;
  std::vector<BodyState> states;
  for (int i = 0; i < count; ++i) {
    models.push_back(kinds[static_cast<std::size_t>(i) % kinds.size()]);
    states.push_back(moving(models.back(), random_in_cube(random, 0.9 * half_edge_m),
                            random_in_cube(random, 1.0)));
    states.back().pose.orientation = random_turn(random);
    states.back().angular_momentum =
        models.back().inverse_inertia.inverse() * random_in_cube(random, 5.0);
  }
  settings.enclosure = ClosedCube{half_edge_m};
  return {std::move(models), std::move(states), std::move(settings)};
}

/// A meter that grants in slices and refuses at random, for good once it did.
class RefusingWork final : public WorkMeter {
 public:
  /// Refuses each request with a chance of one in `mercy`, and grants slices of less than `slice`.
  RefusingWork(RandomStream& random, std::uint64_t mercy, std::uint64_t slice = 100)
      : random_(&random), mercy_(mercy), slice_(slice) {}

  std::int64_t request(WorkPhase phase, std::int64_t total, std::int64_t /*reserved*/) override {
    Granting& granting = phases_[static_cast<std::size_t>(phase)];
    if (total > granting.granted && !granting.refused) {
      granting.refused = random_->below(mercy_) == 0;
      granting.granted = granting.refused
                             ? granting.granted
                             : total + static_cast<std::int64_t>(random_->below(slice_));
    }
    return granting.granted;
  }

 private:
  RandomStream* random_;
  struct Granting {
    std::int64_t granted{0};
    bool refused{false};
  };

  std::uint64_t mercy_;
  std::uint64_t slice_;
  std::array<Granting, kWorkPhases> phases_{};
};

/// One to three lists by thresholds, a region or shares, any traversal and persistence.
inline Schedule random_schedule(RandomStream& random) {
  Schedule schedule;
  schedule.metric = make_metric("eccentricity");
  schedule.lists.clear();
  for (std::uint64_t lists = 1 + random.below(3); lists > 0; --lists) {
    const int least = static_cast<int>(random.below(2));
    const int greatest =
        random.below(3) == 0 ? kUnlimitedLevel : least + static_cast<int>(random.below(3));
    schedule.lists.push_back({random.uniform() + 0.01, least, greatest});
  }
  const std::size_t cuts = schedule.lists.size() - 1;
  if (random.below(2) == 0) {
    schedule.rule = make_list_rule("pair_shares");
    schedule.limits.assign(cuts, 0.3);
  } else if (cuts == 1 && random.below(2) == 0) {
    schedule.rule = make_list_rule("region");
  } else {
    for (std::size_t i = 0; i < cuts; ++i) {
      schedule.limits.push_back(0.5 + static_cast<double>(i));
    }
  }
  const std::vector<std::string_view> traversals = traversal_names();
  schedule.traversal = make_traversal(traversals[random.below(traversals.size())]);
  schedule.persistence_steps = static_cast<std::int64_t>(random.below(6));
  return schedule;
}

/// A whole number of unlike costs, so that a phase counted twice or not at all shows.
inline WorkCosts random_costs(RandomStream& random) {
  const auto cost = [&](std::int64_t least) {
    return least + static_cast<std::int64_t>(random.below(50));
  };
  return {cost(1), cost(1), cost(0), cost(0), cost(0)};
}

inline WorldSettings random_settings(RandomStream& random) {
  constexpr std::array<const char*, 3> kReductions{"none", "average", "groups"};
  WorldSettings settings;
  settings.costs = random.below(2) == 0 ? kAllPhases : random_costs(random);
  settings.schedule = random_schedule(random);
  settings.contacts = {make_reduction(kReductions[random.below(3)]),
                       1 + static_cast<int>(random.below(6))};
  settings.response = random.below(2) == 0 ? ResponseMethod::kInTurn : ResponseMethod::kTogether;
  settings.restitution = random.uniform();
  return settings;
}

/// With a region, for schedules that follow one.
inline StepInput looking_ahead() {
  StepInput input = step_of(kStep_s);
  input.region = GazeRegion{{}, 1.0};
  return input;
}

/// What the step's own report says was due: contacts at their cost, at the least.
inline void expect_within(const StepReport& report, std::int64_t budget, const WorkCosts& costs) {
  ASSERT_LE(report.work_peak, std::max(budget, report.work_floor));
  ASSERT_LE(report.work_spent, report.work_peak);
  ASSERT_LE(report.work_granted, budget);
  ASSERT_GE(report.work_peak, report.work_floor);
  ASSERT_LE(costs.response * static_cast<std::int64_t>(report.contacts.size()),
            report.work_reserved);
  ASSERT_EQ((report.degradations & kFloorOverBudget) != 0, report.work_floor > budget);
}

}  // namespace impetus
