// When frames come late: what a session says, notes and asks.
// SPDX-License-Identifier: MIT
#include "experiments/session/lateness.hpp"

#include <gtest/gtest.h>

#include "experiments/session/session.hpp"
#include "tests/experiments/fakes.hpp"

namespace impetus::lateness_test {

/// A display of which every `each`th frame misses `missed` refreshes.
class LateDisplay final : public Display {
 public:
  LateDisplay(Display& display, int each, std::int64_t missed)
      : display_(display), each_(each), missed_(missed) {}
  [[nodiscard]] double refresh_hz() const override { return display_.refresh_hz(); }
  [[nodiscard]] const ScreenGeometry& geometry() const override { return display_.geometry(); }
  void restart_grid() override { display_.restart_grid(); }
  Flip show(const Picture& picture) override {
    Flip flip = display_.show(picture);
    flip.missed_slots = ++frames_ % each_ == 0 ? missed_ : 0;
    return flip;
  }

 private:
  Display& display_;
  int each_;
  std::int64_t missed_;
  int frames_{0};
};

/// What a session of a lab with late frames said, noted and asked.
struct LateSession {
  SessionResult result;
  std::vector<std::string> told;
  std::vector<std::string> noted;
  std::int64_t stops{0};
};

LateSession late_session(const LatenessRule& rule, int each, std::int64_t missed,
                         std::size_t choice = 0) {
  TestLab lab;
  lab.protocol.script.lateness = rule;
  LateDisplay display(lab.display, each, missed);
  LateSession late;
  lab.input.on_page = [&](const Page& page) {
    Answer answer;
    const bool is_stop = page.title == "Please call the experimenter";
    late.stops += is_stop ? 1 : 0;
    answer.choice = is_stop ? choice : 0;
    return answer;
  };
  const Plan plan = make_plan(lab.protocol.design, {"causality", "P01", 1});
  Ports ports{display, lab.input, lab.scenes, lab.recorder, nullptr, &lab.clock, &lab.clock};
  ports.tell = [&](const std::string& sentence) { late.told.push_back(sentence); };
  late.result = run_session(lab.protocol.script, plan, {}, ports);
  for (const NoteRecord& note : lab.recorder.notes) {
    if (note.kind == kLateFramesNote) {
      late.noted.push_back(note.text);
    }
  }
  return late;
}

using Then = LatenessRule::Then;

TEST(Lateness, OnTimeOrWithinTheLimitNothingIsSaid) {
  EXPECT_TRUE(late_session({Then::kStop, 0.01}, 1'000'000, 1).told.empty());
  EXPECT_TRUE(late_session({Then::kStop, 0.2}, 10, 1).told.empty());
  EXPECT_TRUE(late_session({Then::kNothing, 0.0}, 10, 1).noted.empty());
}

TEST(Lateness, IsToldAtEachBreakAndAtTheEnd) {
  const LateSession late = late_session({}, 10, 1);
  EXPECT_EQ(late.result.ending, SessionEnding::kFinished);
  EXPECT_EQ(late.stops, 0);
  EXPECT_EQ(late.told, late.noted);
  ASSERT_EQ(late.told.size(), 4U) << "practice, two breaks, the end";
  EXPECT_NE(
      late.told[1].find(" timed frames came late, and what was shown took 10 % longer than it "
                        "should"),
      std::string::npos)
      << late.told[1];
}

TEST(Lateness, OfAStimulusThatRunsSlowerThanRealTimeIsToldThoughFewFramesAreLate) {
  // One frame in 500 misses 50 refreshes: 0.2 % of the frames, 10 % of the time.
  EXPECT_EQ(late_session({Then::kTell, 0.05}, 500, 1).told.size(), 0U);
  EXPECT_GE(late_session({Then::kTell, 0.05}, 500, 50).told.size(), 3U);
}

TEST(Lateness, StoppedForItTheExperimenterDecidesAtBreaksAndAfterPractice) {
  const LateSession went_on = late_session({Then::kStop, 0.01}, 10, 1);
  EXPECT_EQ(went_on.result.ending, SessionEnding::kFinished);
  EXPECT_EQ(went_on.stops, 3) << "at the end there is nothing to stop";
  const LateSession stopped = late_session({Then::kStop, 0.01}, 10, 1, /*choice=*/1);
  EXPECT_EQ(stopped.result.ending, SessionEnding::kQuit);
  EXPECT_EQ(stopped.stops, 1);
  EXPECT_EQ(stopped.result.completed_trials, 6);
}

}  // namespace impetus::lateness_test
