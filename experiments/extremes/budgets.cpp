// Budgets of nothing, of one test, and of one test too few.
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "experiments/extremes/building_blocks.hpp"
#include "experiments/extremes/extreme_cases.hpp"

namespace impetus::inline extremes {
namespace {

/// What steps under a budget did that they must not.
struct Breaches {
  double beyond_budget{0.0};  ///< steps that spent or reserved more than granted and the floor
  double untold{0.0};  ///< steps that fell short of their work, and do not say; all, if none fell
  double missed{0.0};  ///< pairs that touch at the finest level, and were reported apart
  double energy_gain{0.0};  ///< as a share of that at the start
};

bool has(const StepReport& report, const BodyPair& bodies) {
  return std::any_of(report.collisions.begin(), report.collisions.end(),
                     [&](const CollisionReport& collision) { return collision.bodies == bodies; });
}

bool stopped_by_budget(const StepReport& report) {
  return std::any_of(
      report.collisions.begin(), report.collisions.end(),
      [](const CollisionReport& collision) { return collision.stop == StopReason::kBudgetSpent; });
}

/// Steps the world with what `budget_of` makes of the work that a copy of it takes without limit.
template <typename BudgetOf>
Breaches step_within(World world, int steps, const BudgetOf& budget_of) {
  Breaches breaches;
  StepInput input;
  input.dt_s = 1.0 / 240.0;
  const double start_J = world.kinetic_energy_J();
  int short_steps = 0;
  for (int step = 0; step < steps; ++step) {
    World unlimited = world;
    FixedWork all(kUnlimitedTests);
    const StepReport whole = unlimited.step(input, all);
    const std::int64_t budget = budget_of(whole.work_spent);
    FixedWork meter(budget);
    const StepReport& report = world.step(input, meter);
    const std::int64_t most = std::max(budget, report.work_floor);
    breaches.beyond_budget += report.work_peak > most || report.work_spent > most ? 1.0 : 0.0;
    const bool said = (report.degradations & kFloorOverBudget) != 0 || stopped_by_budget(report);
    const bool short_of_it = budget < whole.work_spent && report.work_spent < whole.work_spent;
    breaches.untold += short_of_it && !said ? 1.0 : 0.0;
    short_steps += short_of_it ? 1 : 0;
    breaches.missed += static_cast<double>(std::count_if(
        whole.collisions.begin(), whole.collisions.end(), [&](const CollisionReport& touching) {
          return !is_wall(touching.bodies.b) && !has(report, touching.bodies);
        }));
    breaches.energy_gain = std::max(breaches.energy_gain, world.kinetic_energy_J() / start_J - 1.0);
  }
  breaches.untold = short_steps > 0 ? breaches.untold : static_cast<double>(steps);
  return breaches;
}

/// A step may do nothing, one unit of work, or too little for one.
enum class Budget { kNone, kOne, kOneTooFew };

Breaches worst_of(Budget budget, Length length, std::vector<PriorityList> lists) {
  ExtremeScene scene = crowd_scene(40, 1.5, 1.0, 0, TreeKind::kOctree);
  scene.settings.schedule.lists = std::move(lists);
  for (std::size_t i = 1; i < scene.settings.schedule.lists.size(); ++i) {
    scene.settings.schedule.limits.push_back(0.1 * static_cast<double>(i) - 1.0);  // m
  }
  return step_within(world_of(scene), length == Length::kQuick ? 60 : 600,
                     [&](std::int64_t asked) -> std::int64_t {
                       return budget == Budget::kNone  ? 0
                              : budget == Budget::kOne ? 1
                                                       : std::max<std::int64_t>(0, asked - 1);
                     });
}

std::vector<double> figures_of(const Breaches& breaches) {
  return {breaches.beyond_budget, breaches.untold, breaches.missed, breaches.energy_gain};
}

ExtremeCase budget_case(const std::string& name, const std::string& words, Budget budget,
                        const std::vector<PriorityList>& lists) {
  return {"budgets",
          name,
          {{words + ": steps that spend more than is granted and the floor", 0.0},
           {"steps that fall short of their work and do not say so", 0.0},
           {"pairs that touch and are reported apart", 0.0},
           {"energy gained at most", 1e-9}},
          {},
          [budget, lists](Length length, const Progress& /*progress*/) {
            return figures_of(worst_of(budget, length, lists));
          }};
}

}  // namespace

std::vector<ExtremeCase> budget_cases() {
  const std::vector<PriorityList> one{{}};
  const std::vector<PriorityList> last_of_three{{}, {}, {}};  // none is nearer than −1 m
  return {
      budget_case("budget-none", "A squeezed crowd without any budget", Budget::kNone, one),
      budget_case("budget-one", "with a budget of one test", Budget::kOne, one),
      budget_case("budget-one-too-few", "with one test too few", Budget::kOneTooFew, one),
      budget_case("budget-one-list", "with all pairs in one list of three, and one test too few",
                  Budget::kOneTooFew, last_of_three),
  };
}

}  // namespace impetus::inline extremes
