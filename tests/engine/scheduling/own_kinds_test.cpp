// What engine/README.md shows of a library's user: a metric, a traversal, a list rule and a
// reduction of one's own. They stand there as they are compiled here.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>

#include "engine/scheduling/metrics.hpp"
#include "tests/engine/builders.hpp"
#include "tests/engine/deepest_contact.hpp"
#include "tests/places/places.hpp"

namespace impetus::own_kinds_test {

/// Metres per second at which the centres approach each other.
class ApproachMetric final : public PriorityMetric {
 public:
  ApproachMetric() : PriorityMetric(Urgent::kLarge) {}
  [[nodiscard]] unsigned terms() const override { return kMotionTerm; }
  [[nodiscard]] double measure(const PairBounds& bounds, const Viewer& /*viewer*/,
                               const Fixation& /*fixation*/) const override {
    const Vector3 apart = bounds.b.centre - bounds.a.centre;
    const double distance_m = apart.norm();
    return distance_m > 0.0 ? (bounds.velocity_a - bounds.velocity_b).dot(apart) / distance_m : 0.0;
  }
};

/// The coarsest level first; of pairs at one level the nearest to the eye.
class NearLevelsFirst final : public Traversal {
 public:
  [[nodiscard]] unsigned terms() const override { return kProgressTerm | kEyeDistanceTerm; }
  [[nodiscard]] double urgency(const PairProgress& pair) const override {
    const double away_m = pair.eye_distance_m();
    return -pair.level() - away_m / (1.0 + away_m);
  }
};

/// List 0 of two bodies, list 1 of a body and the enclosure.
class WallsApart final : public ListRule {
 public:
  [[nodiscard]] unsigned terms() const override { return 0; }
  void part(const std::vector<PairBounds>& /*bounds*/, const ListInput& /*input*/,
            std::vector<MeasuredPair>& pairs) const override {
    for (MeasuredPair& pair : pairs) {
      pair.scheduled.list = is_wall(pair.scheduled.pair.b) ? 1 : 0;
    }
  }
};

WorldSettings settings_of_ones_own() {
  WorldSettings settings;
  settings.enclosure = ClosedCube{0.6};
  settings.schedule.metric = std::make_shared<ApproachMetric>();
  settings.schedule.traversal = std::make_shared<NearLevelsFirst>();
  settings.schedule.rule = std::make_shared<WallsApart>();
  settings.schedule.lists = {{.share = 0.8}, {.share = 0.2}};
  settings.contacts.reduction = std::make_shared<ReductionBy<DeepestContact>>();
  return settings;
}

World world_of_ones_own(const WorldSettings& settings) {
  const World plain = enclosed_l_blocks(27, /*depth=*/2);
  return {plain.models(), plain.states(), settings};
}

TEST(OwnKinds, DecideWhatIsMeasuredAndInWhichListItIs) {
  World world = world_of_ones_own(settings_of_ones_own());
  FixedWork meter(2'000);
  std::size_t in_list[2] = {0, 0};
  for (int step = 0; step < 240; ++step) {
    const StepReport& report = world.step(step_of(kStep_s), meter);
    for (const CollisionReport& collision : report.collisions) {
      ASSERT_EQ(collision.list, is_wall(collision.bodies.b) ? 1 : 0);
      ASSERT_TRUE(collision.measured.has_value());
      ++in_list[collision.list];
    }
    for (const CollisionReport& collision : report.collisions) {
      if (collision.began && !is_wall(collision.bodies.b)) {
        EXPECT_NE(*collision.measured, 0.0) << "two bodies met that stood still";
      }
    }
  }
  EXPECT_GT(in_list[0], 20U);
  EXPECT_GT(in_list[1], 20U);
}

/// One list further than there are.
class TooFar final : public ListRule {
 public:
  [[nodiscard]] unsigned terms() const override { return 0; }
  void part(const std::vector<PairBounds>& /*bounds*/, const ListInput& /*input*/,
            std::vector<MeasuredPair>& pairs) const override {
    for (MeasuredPair& pair : pairs) {
      pair.scheduled.list = 2;
    }
  }
};

TEST(OwnKinds, AListThatIsNotThereIsRefused) {
  WorldSettings settings = settings_of_ones_own();
  settings.schedule.rule = std::make_shared<TooFar>();
  World world = world_of_ones_own(settings);
  FixedWork meter(2'000);
  EXPECT_THROW(
      {
        for (int step = 0; step < 240; ++step) {
          world.step(step_of(kStep_s), meter);
        }
      },
      std::out_of_range);
}

TEST(OwnKinds, ReplayFromTheWorkGrantedAndEndAloneInTheStateOfAnyOther) {
  World live = world_of_ones_own(settings_of_ones_own());
  World replay = live;
  WorldSettings named = settings_of_ones_own();
  named.schedule = {};
  World whole = live;
  World plain = world_of_ones_own(named);
  for (int step = 0; step < 120; ++step) {
    FixedWork meter(100 * (step % 20));
    const StepReport shown = live.step(step_of(kStep_s), meter);
    FixedWork logged(shown.work_granted);
    ASSERT_EQ(replay.step(step_of(kStep_s), logged).state.hash, shown.state.hash);
    ASSERT_EQ(step_whole(whole).state.hash, step_whole(plain).state.hash) << "orders decide when";
  }
}

TEST(OwnKinds, ATraversalIsAskedForEachPairThatWaitsAndHasNoPlaceForWhatIsNoNumber) {
  class NoNumber final : public Traversal {
   public:
    [[nodiscard]] double urgency(const PairProgress& /*pair*/) const override {
      return std::numeric_limits<double>::quiet_NaN();
    }
  };
  WorldSettings settings = settings_of_ones_own();
  settings.schedule.traversal = std::make_shared<NoNumber>();
  World odd = world_of_ones_own(settings);
  settings.schedule.traversal = make_traversal("depth-first");
  World plain = world_of_ones_own(settings);
  for (int step = 0; step < 60; ++step) {
    FixedWork meter(500);
    ASSERT_EQ(odd.step(step_of(kStep_s), meter).state.hash,
              plain.step(step_of(kStep_s), meter).state.hash);
  }
}

TEST(OwnKinds, WhoPartsListsByLimitsSaysWhatTheyMean) {
  EXPECT_EQ(limited_list_rule_names(), (std::vector<std::string>{"thresholds", "pair_shares"}));
  for (const std::string& name : limited_list_rule_names()) {
    const ListLimits& limits = *make_list_rule(name)->limits();
    EXPECT_LT(limits.least, limits.most) << name;
    for (const std::string_view words : {limits.words, limits.in_panel, limits.of_one}) {
      EXPECT_FALSE(words.empty()) << name;
    }
    EXPECT_NE(limits.is_of_metric, !limits.unit_words.empty()) << name;  // whose unit is shown
  }
  EXPECT_EQ(make_list_rule("region")->limits(), nullptr);
  EXPECT_EQ(WallsApart().limits(), nullptr);
}

TEST(OwnKinds, NamesMakeTheSameObjectAndOthersAreRefused) {
  for (const std::string_view name : traversal_names()) {
    EXPECT_EQ(traversal_name(*make_traversal(name)), name);
  }
  for (const std::string_view name : list_rule_names()) {
    EXPECT_EQ(list_rule_name(*make_list_rule(name)), name);
  }
  EXPECT_EQ(traversal_name(NearLevelsFirst()), "");
  EXPECT_EQ(list_rule_name(WallsApart()), "");
  EXPECT_EQ(Schedule().traversal, make_traversal(traversal_names().front()));
  EXPECT_EQ(Schedule().rule, make_list_rule(list_rule_names().front()));
  const auto refusal = [](const auto& make) -> std::string {
    try {
      make();
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(refusal([] { make_traversal("sideways"); }),
            "traversal: expected one of depth-first, breadth-first, best-first, visible-first, got "
            "\"sideways\"");
  EXPECT_EQ(refusal([] { make_list_rule("colours"); }),
            "list rule: expected one of thresholds, pair_shares, region, got \"colours\"");
  Schedule none;
  none.rule = nullptr;
  EXPECT_EQ(problem_of(none), "schedule: expected a list rule, got none");
  none = {};
  none.traversal = nullptr;
  EXPECT_EQ(problem_of(none), "schedule: expected a traversal, got none");
}

std::string text_of(const std::string& path) {
  std::ifstream file(std::string(source_folder()) + "/" + path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// The blocks of C++ in a section of a page.
std::vector<std::string> blocks_of(const std::string& page, const std::string& section) {
  const std::size_t begin = page.find("## " + section + "\n");
  const std::string within = page.substr(begin, page.find("\n## ", begin) - begin);
  std::vector<std::string> blocks;
  const std::string fence = "```cpp\n";
  for (std::size_t at = within.find(fence); at != std::string::npos; at = within.find(fence, at)) {
    at += fence.size();
    const std::size_t end = within.find("```", at);
    blocks.push_back(within.substr(at, end - at));
    at = end + 3;
  }
  return blocks;
}

TEST(OwnKinds, StandInTheReadmeAsTheyAreCompiled) {
  const std::string page = text_of("engine/README.md");
  const std::string here = text_of("tests/engine/scheduling/own_kinds_test.cpp");
  const std::vector<std::string> schedulers = blocks_of(page, "Schedulers of one's own");
  EXPECT_EQ(schedulers.size(), 4U);
  for (const std::string& block : schedulers) {
    EXPECT_NE(here.find(block), std::string::npos) << block;
  }
  const std::vector<std::string> reductions = blocks_of(page, "Contacts");
  ASSERT_EQ(reductions.size(), 1U);
  EXPECT_NE(text_of("tests/engine/deepest_contact.hpp").find(reductions[0]), std::string::npos);
}

}  // namespace impetus::own_kinds_test
