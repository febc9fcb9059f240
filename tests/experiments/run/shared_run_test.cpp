// Who is asked to help with a scene's steps.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <memory>
#include <utility>

#include "experiments/run/scene_run.hpp"
#include "tests/experiments/test_scenes.hpp"
#include "tests/experiments/trade_pairs.hpp"

namespace impetus::shared_run_test {

/// Helps in turn, and counts how often.
class CountedWorkers final : public Workers {
 public:
  [[nodiscard]] int count() const override { return 2; }
  void run(const std::function<void(int worker)>& job) override {
    ++asked;
    job(0);
    job(1);
  }

  int asked{0};
};

/// How often helpers are asked in ten steps of few bodies that are fast.
int asked_in_steps(const WorkBudget& budget) {
  const auto workers = std::make_shared<CountedWorkers>();
  SceneRun::share_work_with(workers);
  StagedScene scene = built(json::parse(shipped("tests/builds/far-and-fast-scene.json")));
  scene.budget = budget;
  const StillClock clock;
  SceneRun run(std::move(scene), 1, &clock);
  for (int step = 0; step < 10; ++step) {
    run.step();
  }
  SceneRun::share_work_with(nullptr);
  return workers->asked;
}

TEST(SharedRun, AStepIsSharedUnlessItsBudgetIsInMilliseconds) {
  WorkBudget budget;
  EXPECT_GT(asked_in_steps(budget), 0);
  budget.ns_per_step = 1'000'000'000;
  EXPECT_EQ(asked_in_steps(budget), 0);
}

}  // namespace impetus::shared_run_test
