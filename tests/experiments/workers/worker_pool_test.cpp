// A pool does every job once for each worker, tells what failed, and changes nothing of a step that
// is shared among its threads, whatever is granted of it.
// SPDX-License-Identifier: MIT
#include "experiments/workers/worker_pool.hpp"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <chrono>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>

#include "tests/engine/squeezed_steps.hpp"

namespace impetus::worker_pool_test {

constexpr std::uint64_t kSeed = 279;
constexpr double kHalfEdge_m = 0.13;

TEST(WorkerPool, DoesEachJobOnceForEachWorker) {
  WorkerPool pool(4);
  ASSERT_EQ(pool.count(), 4);
  for (int round = 0; round < 20'000; ++round) {
    std::array<std::atomic<int>, 4> done{};
    pool.run([&](int worker) { ++done.at(static_cast<std::size_t>(worker)); });
    for (const std::atomic<int>& times : done) {
      ASSERT_EQ(times, 1) << "round " << round;
    }
  }
}

TEST(WorkerPool, WakesThreadsThatFellAsleep) {
  WorkerPool pool(3);
  for (int round = 0; round < 5; ++round) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    std::atomic<int> sum{0};
    pool.run([&](int worker) { sum += worker; });
    ASSERT_EQ(sum, 1 + 2);
  }
}

TEST(WorkerPool, ThrowsWhatAJobThrewAndGoesOn) {
  WorkerPool pool(3);
  for (int failing = 0; failing < 3; ++failing) {
    const auto fail = [failing](int worker) {
      if (worker == failing) {
        throw std::runtime_error(std::to_string(worker));
      }
    };
    std::string said;
    try {
      pool.run(fail);
    } catch (const std::runtime_error& error) {
      said = error.what();
    }
    EXPECT_EQ(said, std::to_string(failing));
    std::atomic<int> done{0};
    pool.run([&](int /*worker*/) { ++done; });
    EXPECT_EQ(done, 3);
  }
}

TEST(WorkerPool, LeavesWhoAsksWhileItIsBusyToHimself) {
  WorkerPool pool(2);
  std::atomic<int> inner{0};
  pool.run([&](int worker) {
    if (worker == 0) {
      std::thread([&] { pool.run([&](int each) { inner += each + 1; }); }).join();
    }
  });
  EXPECT_EQ(inner, 1 + 2);
}

TEST(WorkerPool, NeedsAWorker) {
  EXPECT_THROW(WorkerPool(0), std::invalid_argument);
  EXPECT_EQ(WorkerPool(1).count(), 1);
}

/// Tells how often it was asked.
class CountedPool final : public Workers {
 public:
  explicit CountedPool(int count) : pool_(count) {}
  [[nodiscard]] int count() const override { return pool_.count(); }
  void run(const std::function<void(int worker)>& job) override {
    ++asked;
    pool_.run(job);
  }

  int asked{0};

 private:
  WorkerPool pool_;
};

/// A crowd of trees of every kind, so fast that most pairs are searched.
World fast_crowd(RandomStream& random, std::int64_t most_entry_tests) {
  WorldSettings settings = random_settings(random);
  settings.tunnelling = Tunnelling::kStopAtEntry;
  settings.rotation = Rotation::kEnergyKept;
  settings.most_entry_tests = most_entry_tests;
  World world = squeezed_crowd(random, bodies_of_every_tree_kind(), 14, kHalfEdge_m, settings);
  for (BodyState& state : world.mutable_states()) {
    state.linear_momentum *= 20.0;
  }
  return world;
}

void expect_same(const StepReport& shared, const StepReport& alone) {
  ASSERT_EQ(shared.state.hash, alone.state.hash);
  ASSERT_EQ(shared.work_floor, alone.work_floor);
  ASSERT_EQ(shared.work_spent, alone.work_spent);
  ASSERT_EQ(shared.degradations, alone.degradations);
  ASSERT_EQ(shared.grants, alone.grants);
  ASSERT_EQ(shared.stopped.size(), alone.stopped.size());
  for (std::size_t i = 0; i < shared.stopped.size(); ++i) {
    ASSERT_EQ(shared.stopped[i].bodies, alone.stopped[i].bodies);
    ASSERT_EQ(shared.stopped[i].fraction, alone.stopped[i].fraction);
  }
}

TEST(SharedSteps, AreThoseOfOneWorker) {
  RandomStream random(kSeed, "whole");
  std::size_t stopped = 0;
  for (const std::int64_t most_tests : {kUnlimitedTests, std::int64_t{20'000}, std::int64_t{300}}) {
    for (const int count : {2, 3}) {
      World alone = fast_crowd(random, most_tests);
      World shared = alone;
      const auto pool = std::make_shared<CountedPool>(count);
      shared.share_work_with(pool);
      for (int step = 0; step < 16; ++step) {
        SCOPED_TRACE("step " + std::to_string(step) + " of " + std::to_string(count));
        const StepReport& report = step_whole(shared, 0.02);
        stopped += report.stopped.size();
        expect_same(report, step_whole(alone, 0.02));
        ASSERT_FALSE(HasFatalFailure());
      }
      EXPECT_EQ(pool->asked > 0, most_tests > 3'000) << "where few tests are left nobody helps";
    }
  }
  EXPECT_GT(stopped, 200U);
}

TEST(SharedSteps, AreTheSameWhereverTheSearchForEntriesIsCut) {
  RandomStream random(kSeed, "cut");
  int cut = 0;
  for (int crowd = 0; crowd < 8; ++crowd) {
    World alone = fast_crowd(random, kUnlimitedTests);
    World shared = alone;
    shared.share_work_with(std::make_shared<WorkerPool>(2));
    for (int step = 0; step < 20; ++step) {
      SCOPED_TRACE("crowd " + std::to_string(crowd) + ", step " + std::to_string(step));
      WorkGrants grants;
      grants.of(WorkPhase::kEntry) = static_cast<std::int64_t>(random.below(300'000));
      FixedWork for_shared(grants);
      FixedWork for_alone(grants);
      StepInput input = looking_ahead();
      input.dt_s = 0.02;
      const StepReport& report = shared.step(input, for_shared);
      cut += (report.degradations & kEntryTestsSpent) != 0 ? 1 : 0;
      expect_same(report, alone.step(input, for_alone));
      ASSERT_FALSE(HasFatalFailure());
    }
  }
  EXPECT_GT(cut, 20);
  EXPECT_LT(cut, 140);
}

TEST(SharedSteps, ReplayFromTheirLogByOneWorker) {
  RandomStream random(kSeed, "grants");
  SqueezedSteps seen;
  for (int crowd = 0; crowd < 5; ++crowd) {
    World live = fast_crowd(random, kUnlimitedTests);
    live.share_work_with(std::make_shared<WorkerPool>(2));
    expect_squeezed_steps_hold(random, std::move(live), 30, 1e-9, seen);
    ASSERT_FALSE(HasFatalFailure()) << "crowd " << crowd;
  }
  EXPECT_GT(seen.steps_cut, 75);
}

/// Grants in slices, and refuses at random: as a deadline does.
TEST(SharedSteps, OfADeadlineReplayFromTheirLogByOneWorker) {
  RandomStream random(kSeed, "refusing");
  int cut = 0;
  for (int crowd = 0; crowd < 5; ++crowd) {
    World replay = fast_crowd(random, kUnlimitedTests);
    World live = replay;
    live.share_work_with(std::make_shared<WorkerPool>(2));
    for (int step = 0; step < 20; ++step) {
      SCOPED_TRACE("crowd " + std::to_string(crowd) + ", step " + std::to_string(step));
      RefusingWork meter(random, 40, 20'000);
      const StepReport& report = live.step(looking_ahead(), meter);
      cut += report.grants.cut_beyond_refinement() ? 1 : 0;
      FixedWork logged(grants_of(report));
      expect_same(report, replay.step(looking_ahead(), logged));
      ASSERT_FALSE(HasFatalFailure());
    }
  }
  EXPECT_GT(cut, 25);
}

}  // namespace impetus::worker_pool_test
