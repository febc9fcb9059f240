// SPDX-License-Identifier: MIT
#include "engine/scheduling/deadline_work.hpp"

#include <gtest/gtest.h>

#include "engine/world/world.hpp"
#include "tests/engine/builders.hpp"
#include "tests/engine/crowds.hpp"

namespace impetus::deadline_work_test {

/// Goes on by the same time at every look.
class TickingClock final : public WorkClock {
 public:
  explicit TickingClock(std::int64_t tick_ns) : tick_ns_(tick_ns) {}
  [[nodiscard]] std::int64_t now_ns() const override { return now_ns_ += tick_ns_; }

 private:
  std::int64_t tick_ns_;
  mutable std::int64_t now_ns_{0};
};

/// Stands still unless it is moved.
class StandingClock final : public WorkClock {
 public:
  [[nodiscard]] std::int64_t now_ns() const override { return now; }
  std::int64_t now{0};
};

/// Asks for tests with nothing reserved.
std::int64_t ask(DeadlineWork& meter, std::int64_t total) {
  return meter.request(WorkPhase::kTests, total, 0);
}

TEST(DeadlineWork, GrantsWhatIsAskedBeforeTheDeadline) {
  const TickingClock clock(1);
  DeadlineWork meter(clock, 1'000'000);
  meter.start_step();
  for (std::int64_t total = 100; total <= 10'000; total += 100) {
    EXPECT_GE(ask(meter, total), total);
  }
}

TEST(DeadlineWork, OnceRefusedTheAnswerNeverRises) {
  for (std::size_t phase = 0; phase < kWorkPhases; ++phase) {
    if (static_cast<WorkPhase>(phase) == WorkPhase::kRefinement) {
      continue;  // not metered by time but through its tests
    }
    const TickingClock clock(100'000);
    DeadlineWork meter(clock, 1'000'000);
    meter.start_step();
    std::int64_t most = 0;
    std::int64_t total = 1;
    while (most >= total - 1) {
      most = meter.request(static_cast<WorkPhase>(phase), total, 0);
      total = most + 1;
      ASSERT_LT(total, 1'000'000) << "never refused";
      if (most < total - 1) {
        break;
      }
      if (meter.request(static_cast<WorkPhase>(phase), total, 0) < total) {
        break;
      }
    }
    most = meter.request(static_cast<WorkPhase>(phase), total, 0);
    for (const std::int64_t other : {total + 1, total + 100, std::int64_t{1}}) {
      EXPECT_EQ(meter.request(static_cast<WorkPhase>(phase), other, 0), most) << other;
    }
  }
}

TEST(DeadlineWork, ARequestAfterTheDeadlineIsRefused) {
  const TickingClock clock(10);
  DeadlineWork meter(clock, 5);
  meter.start_step();
  for (std::size_t phase = 0; phase < kWorkPhases; ++phase) {
    if (static_cast<WorkPhase>(phase) == WorkPhase::kRefinement) {
      continue;  // not metered by time but through its tests
    }
    EXPECT_EQ(meter.request(static_cast<WorkPhase>(phase), 1, 0), 0);
  }
}

TEST(DeadlineWork, NothingIsGrantedBeforeTheFirstStep) {
  const TickingClock clock(10);
  DeadlineWork meter(clock, 1'000'000'000);
  EXPECT_EQ(ask(meter, 1), 0);
}

TEST(DeadlineWork, TheNextStepHasItsOwnTime) {
  const TickingClock clock(1'000);
  DeadlineWork meter(clock, 1'600);
  for (int step = 0; step < 3; ++step) {
    meter.start_step();
    EXPECT_GE(ask(meter, 500), 500);
    EXPECT_LT(ask(meter, 50'000), 50'000);
  }
}

TEST(DeadlineWork, WhatIsReservedMustStillFitBeforeTheDeadline) {
  // When refinement begins .3 of the time that is left is its own at least. Later looks are refused
  // when what is reserved, at some ns a unit, does not fit into the rest.
  for (const std::int64_t reserved : {std::int64_t{0}, std::int64_t{1'000'000}}) {
    const TickingClock clock(100'000);
    DeadlineWork meter(clock, 1'000'000);
    meter.start_step();
    int granted = 0;
    while (meter.request(WorkPhase::kTests, 1'000'000 * (granted + 1), reserved) >=
           1'000'000 * (granted + 1)) {
      ++granted;
    }
    // Begun at 100, looked at 200, 300 ... us, the end is at 1,085: nine looks. Of the 885 us that
    // were left at the first .7 are kept, where so much is reserved: those at 200, 300, 400.
    EXPECT_EQ(granted, reserved == 0 ? 9 : 3);
  }
}

TEST(DeadlineWork, AShareOfTheTimeIsKeptForTheResponse) {
  const TickingClock clock(50'000);
  DeadlineWork meter(clock, 1'000'000);
  meter.start_step();
  std::int64_t total = 1;
  while (meter.request(WorkPhase::kEntry, total, 0) >= total) {
    total += 1'000'000;
  }
  // Of some .9 ms that were left at the first look .4 may be used: seven or eight looks.
  EXPECT_NEAR(static_cast<double>(total) / 1e6, 8.0, 1.0);
  EXPECT_GE(meter.request(WorkPhase::kResponse, 1, 0), 1) << "the response has time of its own";
}

TEST(DeadlineWork, WhatAPairTakesIsLearnedFromSteps) {
  // Pairs of 1,000 ns where 250 were guessed: after some steps no more are granted than fit.
  StandingClock clock;
  DeadlineWork meter(clock, 1'000'000);
  std::int64_t granted = 0;
  for (int step = 0; step < 20; ++step) {
    meter.start_step();
    meter.begin(StepPart::kMove, 1);
    meter.begin(StepPart::kPair, 1);
    granted = meter.request(WorkPhase::kPairs, 1'000'000, 0);
    meter.begin(StepPart::kRefine, granted);
    clock.now += 1'000 * granted;
    ask(meter, granted);
    meter.finish();
  }
  EXPECT_NEAR(static_cast<double>(granted), 454.0, 5.0)
      << ".6 of the budget, of which a pair takes 300 ns more where entries are refused";
}

TEST(DeadlineWork, AClockTooCoarseToSeeAStepGrantsAllThatIsAsked) {
  const StandingClock clock;
  DeadlineWork meter(clock, 16'000'000);
  World world = enclosed_l_blocks(64, /*depth=*/2);
  for (int step = 0; step < 600; ++step) {
    meter.start_step();
    const StepReport& report = world.step(step_of(1.0 / 240.0), meter);
    ASSERT_EQ(report.degradations & (kPairsLeft | kEntryTestsSpent | kContactsLeft | kResponseCut),
              0U)
        << step;
  }
  LearnedTime time(10.0);
  for (int i = 0; i < 10'000; ++i) {
    time.learn(0.0, 1.0);
    time.doubt();
  }
  EXPECT_EQ(time.ns(), LearnedTime::kLeast_ns);
}

/// A step in which `walls` bodies are modelled at walls, whatever is granted, and so many other
/// units if they are; returns whether a test was granted before.
bool step_with_walls(StandingClock& clock, DeadlineWork& meter, std::int64_t walls,
                     std::int64_t wall_ns = 2'000, std::int64_t others = 0) {
  meter.start_step();
  meter.begin(StepPart::kMove, 1);
  meter.begin(StepPart::kRefine, walls);
  meter.expect_at_walls(walls);
  const bool granted = ask(meter, 1) >= 1;
  meter.begin(StepPart::kModel, walls);
  meter.request(WorkPhase::kModel, others, 0);
  clock.now += wall_ns * walls;
  meter.begin(StepPart::kRespond, walls);
  meter.finish();
  return granted;
}

TEST(DeadlineWork, TimeForContactsWithWallsIsKeptFree) {
  StandingClock clock;
  DeadlineWork meter(clock, 1'000'000);
  for (int step = 0; step < 5; ++step) {
    EXPECT_TRUE(step_with_walls(clock, meter, 100)) << "they take a fifth of the time";
  }
  EXPECT_FALSE(step_with_walls(clock, meter, 600)) << "as learned, they take more than there is";
  EXPECT_TRUE(step_with_walls(clock, meter, 450)) << "which is told anew in each step";
}

TEST(DeadlineWork, WhatNothingInterruptsIsRememberedAtItsLongest) {
  const auto after_a_long_one = [](double fall) {
    LearnedTime time(100.0, fall);
    time.learn(200.0, 1.0);
    for (int step = 0; step < 10; ++step) {
      time.learn(100.0, 1.0);
    }
    return time.ns();
  };
  EXPECT_GT(after_a_long_one(LearnedTime::kSlowFall), 180.0);
  EXPECT_LT(after_a_long_one(LearnedTime::kFastFall), 140.0);
}

TEST(DeadlineWork, WallsAreLearnedBesideWhatElseIsModelled) {
  StandingClock clock;
  DeadlineWork meter(clock, 4'000'000);
  const auto step = [&](std::int64_t walls) {
    return step_with_walls(clock, meter, walls, /*wall_ns=*/8'000, /*others=*/100);
  };
  for (int steps = 0; steps < 10; ++steps) {
    EXPECT_TRUE(step(100)) << "they take a fifth of the time";
  }
  EXPECT_FALSE(step(600)) << "as learned, they take more than there is";
}

/// A step whose search for entries begins with 10,000 units at once, `unit_ns` each, and asks for
/// one more; returns whether it began.
bool step_with_entries(StandingClock& clock, DeadlineWork& meter, std::int64_t unit_ns) {
  constexpr std::int64_t kUnits = 10'000;
  meter.start_step();
  meter.begin(StepPart::kMove, 1);
  const bool began = meter.request(WorkPhase::kEntry, kUnits, 0) >= kUnits;
  clock.now += began ? unit_ns * kUnits : 0;
  meter.request(WorkPhase::kEntry, kUnits + 1'000'000, 0);
  meter.finish();
  return began;
}

TEST(DeadlineWork, WhatAPhaseBeginsWithMustFitAsLearnedAndIsTriedAgain) {
  StandingClock clock;
  DeadlineWork meter(clock, 1'000'000);
  int began = 0;
  for (int step = 0; step < 10; ++step) {
    began += step_with_entries(clock, meter, /*unit_ns=*/100) ? 1 : 0;
  }
  EXPECT_GT(began, 0);
  EXPECT_LT(began, 5) << "it takes as long as there is for the whole step";
  began = 0;
  for (int step = 0; step < 20; ++step) {
    began += step_with_entries(clock, meter, /*unit_ns=*/10) ? 1 : 0;
  }
  EXPECT_GT(began, 10) << "a quarter of the time that a search may take";
}

TEST(DeadlineWork, MoreIsModelledThanEverOnlyAsFarAsNewMemoryAllows) {
  StandingClock clock;
  DeadlineWork meter(clock, 1'000'000);
  std::int64_t before = 0;
  for (int step = 0; step < 5; ++step) {
    meter.start_step();
    meter.begin(StepPart::kMove, 1);
    meter.begin(StepPart::kModel, 0);
    const std::int64_t granted = meter.request(WorkPhase::kModel, 1'000'000, 0);
    EXPECT_GT(granted, before);
    // What is new takes twenty times as long as the rest, and the step holds.
    clock.now += 8 * before + 160 * (granted - before);
    meter.begin(StepPart::kRespond, 0);
    EXPECT_LT(clock.now, 1'000'000 * (step + 1));
    clock.now = 1'000'000 * (step + 1);
    before = granted;
    if (step == 0) {
      EXPECT_LT(granted, 1'000'000 / 160);
    }
  }
}

TEST(DeadlineWork, TimeForWhatFiguresMoveInAnyCaseIsKeptFree) {
  // Once it is refused, what remains of the motion takes half of the time.
  StandingClock clock;
  DeadlineWork meter(clock, 1'000'000);
  std::int64_t granted_ns = 0;
  for (int step = 0; step < 10; ++step) {
    meter.start_step();
    meter.begin(StepPart::kMove, 100);
    const std::int64_t began_ns = clock.now;
    for (std::int64_t total = 1; meter.request(WorkPhase::kMotion, total, 0) >= total; ++total) {
      clock.now += 1'000;
    }
    granted_ns = clock.now - began_ns;
    clock.now += 500'000;
    meter.begin(StepPart::kPair, 100);
    meter.finish();
  }
  EXPECT_GT(granted_ns, 0);
  EXPECT_LT(granted_ns, 200'000) << ".4 of what remains beside it";
}

TEST(DeadlineWork, TimeForWhatRefinementLeavesIsKeptFree) {
  // Once tests are refused, the pairs that still wait take a third of the time.
  constexpr std::int64_t kPairs = 100;
  StandingClock clock;
  DeadlineWork meter(clock, 1'000'000);
  std::int64_t took_ns = 0;
  for (int step = 0; step < 10; ++step) {
    const std::int64_t began_ns = clock.now;
    meter.start_step();
    meter.begin(StepPart::kMove, 1);
    meter.request(WorkPhase::kPairs, kPairs, 0);
    meter.begin(StepPart::kRefine, kPairs);
    for (std::int64_t total = 1; ask(meter, total) >= total; ++total) {
      clock.now += 1'000;
    }
    clock.now += 300'000;
    meter.begin(StepPart::kModel, 0);
    meter.finish();
    took_ns = clock.now - began_ns;
  }
  EXPECT_GT(took_ns, 900'000) << "the rest is used";
  EXPECT_LT(took_ns, 1'000'000);
}

TEST(DeadlineWork, AStepUnderItReplaysWithWhatItGranted) {
  constexpr int kSteps = 240;
  constexpr int kDepth = 4;
  World timed = enclosed_l_blocks(27, kDepth);
  World again = timed;
  const TickingClock clock(1'000);
  int short_of_work = 0;
  int cut_elsewhere = 0;
  for (int step = 0; step < kSteps; ++step) {
    // From no time at all to plenty, so that every kind of cut occurs.
    DeadlineWork meter(clock, 1'000 * (step % 40));
    meter.start_step();
    const StepReport report = timed.step(step_of(kStep_s), meter);
    FixedWork recorded(grants_of(report));
    const StepReport replayed = again.step(step_of(kStep_s), recorded);
    ASSERT_EQ(replayed.state.hash, report.state.hash) << "step " << step;
    ASSERT_EQ(replayed.work_granted, report.work_granted) << "step " << step;
    ASSERT_EQ(replayed.work_spent, report.work_spent) << "step " << step;
    ASSERT_EQ(replayed.degradations, report.degradations) << "step " << step;
    ASSERT_EQ(replayed.grants, report.grants) << "step " << step;
    cut_elsewhere += report.grants.cut_beyond_refinement() ? 1 : 0;
    for (const CollisionReport& collision : report.collisions) {
      short_of_work += collision.stop == StopReason::kBudgetSpent ? 1 : 0;
    }
  }
  EXPECT_GT(short_of_work, 0) << "the deadline cut nothing";
  EXPECT_GT(cut_elsewhere, 0) << "the deadline cut nothing but refinement";
}

}  // namespace impetus::deadline_work_test
