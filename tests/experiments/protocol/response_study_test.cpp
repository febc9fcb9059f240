// The response study: collisions that turn, and the random spin of those that would not.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "experiments/protocol/checks/protocol_checks.hpp"
#include "experiments/protocol/solved_values.hpp"
#include "experiments/protocol/spin_limits.hpp"
#include "experiments/run/live_run.hpp"
#include "tests/experiments/fakes.hpp"
#include "tests/experiments/refusals.hpp"

namespace impetus::response_study_test {

constexpr double kHz = 60.0;
constexpr std::int64_t kContactStep = 240;

/// The shipped study, its limits from a tenth of the runs.
const Protocol& response() {
  static const Protocol protocol = [] {
    json document = json::parse(shipped("protocols/response.json"));
    document["solve"][0]["runs"] = 20;
    return make_protocol(parse_json("response.json", document.dump()),
                         parse_json("scene.json", shipped("stimuli/two-l-blocks-off-centre.json")));
  }();
  return protocol;
}

/// Blocks are built once for all tests.
const std::shared_ptr<ShapeLibrary>& shapes() {
  static const auto library = std::make_shared<ShapeLibrary>();
  return library;
}

const std::vector<SolvedFor>& solved() {
  static const std::vector<SolvedFor> values = solve(response(), *shapes());
  return values;
}

PlannedTrial trial_of(double level, double viewpoint_deg, double speed_percent,
                      std::uint64_t seed) {
  PlannedTrial trial;
  trial.condition = {
      {"level", level}, {"viewpoint_deg", viewpoint_deg}, {"speed_percent", speed_percent}};
  trial.seed = seed;
  Plan plan{trial};
  put_solved(solved(), plan);
  return plan.front();
}

struct Played {
  std::vector<CollisionRecord> collisions;
  std::vector<Vector3> velocities;  ///< at the end
  std::vector<Vector3> spins;       ///< rad/s
};

Played play(const PlannedTrial& trial) {
  static const ProtocolScenes scenes(response(), 0.0, shapes());
  LiveRun live(scenes.stage(trial, assumed_screen()), trial.seed);
  const auto frames = static_cast<std::int64_t>(live.scene().duration_s * kHz);
  for (std::int64_t frame = 0; frame <= frames; ++frame) {
    live.poses_at(static_cast<double>(frame) / kHz);
  }
  Played played;
  played.collisions = live.take_collisions();
  const World& world = live.scene().world;
  for (std::size_t body = 0; body < 2; ++body) {
    played.velocities.push_back(velocity(world.models()[body], world.states()[body]));
    played.spins.push_back(angular_velocity(world.models()[body], world.states()[body]));
  }
  return played;
}

double limit(const PlannedTrial& trial, const std::string& place) {
  const auto found = std::find_if(
      trial.solved.begin(), trial.solved.end(),
      [&](const SolvedValue& value) { return value.pointer == "/imposed/random_spin/" + place; });
  return found == trial.solved.end() ? std::nan("") : found->value;
}

TEST(ResponseStudy, HasEightyOneTrialsEachWithTheLimitsOfItsSpeed) {
  Plan plan = plan_for(response(), "P01", 1);
  put_solved(solved(), plan);
  EXPECT_EQ(std::count_if(plan.begin(), plan.end(),
                          [](const auto& trial) { return trial.phase == TrialPhase::kMain; }),
            81);
  for (const PlannedTrial& trial : plan) {
    ASSERT_EQ(trial.solved.size(), 12U);
  }
  const double slow = limit(trial_of(0, 0, 50, 1), "a/most_rad_s/2");
  const double fast = limit(trial_of(0, 0, 150, 1), "a/most_rad_s/2");
  // The change of spin grows with the speed; a step's rounding of the place of contact is 1 %.
  EXPECT_NEAR(fast / slow, 3.0, 0.3);
}

TEST(ResponseStudy, ContactFallsOnItsStepAtTheLevelAskedInEveryCell) {
  for (const Condition& cell : cells(response().design)) {
    PlannedTrial trial;
    trial.condition = cell;
    const Played played = play(trial);
    ASSERT_FALSE(played.collisions.empty()) << to_json(cell).dump();
    EXPECT_EQ(played.collisions[0].step, kContactStep) << to_json(cell).dump();
    EXPECT_EQ(played.collisions[0].report.level, static_cast<int>(std::get<double>(cell[0].value)));
    // The bodies overlap by 1e-9 of their distance, some centimetres.
    EXPECT_NEAR(played.collisions[0].report.contact.touch.point.x(), 0.0, 1e-10);
  }
}

TEST(ResponseStudy, AnAccurateCollisionChangesDirectionAndSpinAndNothingIsImposed) {
  const Played played = play(trial_of(4, 0, 100, 7));
  for (std::size_t body = 0; body < 2; ++body) {
    const Vector3& after = played.velocities[body];
    EXPECT_GT(std::hypot(after.y(), after.z()), 0.05 * after.norm()) << "off the line of approach";
    EXPECT_GT(played.spins[body].norm(), 0.5);
  }
  EXPECT_FALSE(played.collisions[0].imposed_spin);
}

TEST(ResponseStudy, AtTheRootNothingTurnsButByTheDrawWhichIsLoggedAndWithinTheLimits) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const PlannedTrial trial = trial_of(0, 0, 100, seed);
    const Played played = play(trial);
    ASSERT_TRUE(played.collisions[0].imposed_spin);
    const ImposedSpin& drawn = *played.collisions[0].imposed_spin;
    for (Eigen::Index i = 0; i < 3; ++i) {
      const std::string component = "_rad_s/" + std::to_string(i);
      EXPECT_GE(drawn.a[i], limit(trial, "a/least" + component));
      EXPECT_LE(drawn.a[i], limit(trial, "a/most" + component));
      EXPECT_GE(drawn.b[i], limit(trial, "b/least" + component));
      EXPECT_LE(drawn.b[i], limit(trial, "b/most" + component));
    }
    // Spun from rest, the angular momentum is that of the draw; angular velocity then precesses.
    EXPECT_NEAR(played.spins[0].norm(), drawn.a.norm(), 0.5 * drawn.a.norm());
    EXPECT_GT(played.spins[1].norm(), 0.0);
  }
}

TEST(ResponseStudy, TheDrawFollowsFromTheTrialsSeedAlone) {
  const auto drawn = [](std::uint64_t seed, double viewpoint_deg) {
    return play(trial_of(0, viewpoint_deg, 100, seed)).collisions[0].imposed_spin->a;
  };
  EXPECT_EQ(drawn(3, 0), drawn(3, 85));
  EXPECT_NE(drawn(3, 0), drawn(4, 0));
}

TEST(ResponseStudy, SwitchedOffTheRootTurnsNothing) {
  json scene = json::parse(shipped("stimuli/two-l-blocks-off-centre.json"));
  scene["imposed"]["random_spin"]["on"] = false;
  const Protocol off = make_protocol(response().document, parse_json("scene.json", scene.dump()));
  const ProtocolScenes scenes(off, 0.0, shapes());
  LiveRun live(scenes.stage(trial_of(0, 0, 100, 1), assumed_screen()), 1);
  live.poses_at(2.0);
  for (const BodyState& state : live.scene().world.states()) {
    // Rounding of a lever arm and an impulse of some 1e-4 kg m/s.
    EXPECT_LT(state.angular_momentum.norm(), 1e-18);
  }
  EXPECT_FALSE(live.take_collisions()[0].imposed_spin);
}

TEST(SpinLimits, AreTheSameWheneverTheyAreSolvedAndEmbraceTheAccurateCollision) {
  const std::vector<SolvedFor> again = solve(response(), *shapes());
  ASSERT_EQ(again.size(), solved().size());
  for (std::size_t i = 0; i < again.size(); ++i) {
    EXPECT_EQ(again[i].values, solved()[i].values);
  }
  const PlannedTrial trial = trial_of(0, 0, 100, 1);
  const Vector3 accurate = play(trial_of(4, 0, 100, 1)).spins[0];
  double largest = 0.0;
  for (int i = 0; i < 3; ++i) {
    const std::string component = "_rad_s/" + std::to_string(i);
    EXPECT_LT(limit(trial, "a/least" + component), limit(trial, "a/most" + component));
    largest = std::max({largest, std::abs(limit(trial, "a/least" + component)),
                        std::abs(limit(trial, "a/most" + component))});
  }
  EXPECT_LT(accurate.norm(), 3.0 * largest) << "of the same size";
  EXPECT_GT(accurate.norm(), largest / 3.0);
}

TEST(SpinLimits, PercentilesAreLinearBetweenNeighbours) {
  // Type 7 of Hyndman and Fan 1996: 1 + .05 · 20 = 2 and 1 + .95 · 20 = 20 of 1 ... 21.
  std::vector<double> values(21);
  std::iota(values.rbegin(), values.rend(), 1.0);
  EXPECT_DOUBLE_EQ(percentile(values, 5.0), 2.0);
  EXPECT_DOUBLE_EQ(percentile(values, 95.0), 20.0);
  EXPECT_DOUBLE_EQ(percentile({1.0, 2.0}, 25.0), 1.25);
  EXPECT_EQ(percentile({4.0}, 95.0), 4.0);
}

TEST(SolvedValues, GoToTextAndBackToTheLastBit) {
  const std::vector<SolvedValue> values{{"/a/0", 0.1 + 0.2}, {"/b", -1e-300}};
  EXPECT_EQ(solved_values_from(to_text(values)), values);
  EXPECT_EQ(to_text(std::vector<SolvedValue>{}), "");
  EXPECT_TRUE(solved_values_from("").empty());
}

/// The sentence with which the shipped study is refused with one value changed.
std::string response_refusal(const std::string& pointer, const json& value,
                             const std::string& scene_pointer = "", const json& scene_value = {}) {
  json document = json::parse(shipped("protocols/response.json"));
  json scene = json::parse(shipped("stimuli/two-l-blocks-off-centre.json"));
  if (!pointer.empty()) {
    document[json::json_pointer(pointer)] = value;
  }
  if (!scene_pointer.empty()) {
    scene[json::json_pointer(scene_pointer)] = scene_value;
  }
  return refusal([&] {
    static_cast<void>(
        make_protocol(parse_json("r.json", document.dump()), parse_json("s.json", scene.dump())));
  });
}

TEST(SolveChecks, NameWhatIsWrong) {
  EXPECT_EQ(response_refusal("/solve/0/for_each/0", "colour"),
            "r.json:/solve/0/for_each/0: expected the name of a factor, got \"colour\"");
  EXPECT_EQ(response_refusal("/solve/0/share", 0.5),
            "r.json:/solve/0/share: expected none for kind random-spin-limits");
  EXPECT_EQ(response_refusal("/solve/0/kind", "equal-lists"),
            "r.json:/solve/0: expected the key \"share\" for kind equal-lists, which is missing");
  EXPECT_EQ(response_refusal("/solve/0/pointer", "/imposed"),
            "r.json:/solve/0/pointer: expected \"/imposed/random_spin\", got \"/imposed\"");
  EXPECT_EQ(response_refusal("/solve/0/percentiles", json::array({95, 5})),
            "r.json:/solve/0/percentiles: expected the lower first, got [95,5]");
}

TEST(SolveChecks, AStartThatLeadsToNoCollisionIsSaid) {
  json document = json::parse(shipped("protocols/response.json"));
  document["solve"][0]["runs"] = 20;
  document["solve"][0]["size_share"] = 1;
  json scene = json::parse(shipped("stimuli/two-l-blocks-off-centre.json"));
  const Protocol far =
      make_protocol(parse_json("r.json", document.dump()), parse_json("s.json", scene.dump()));
  const std::string sentence = refusal([&] { static_cast<void>(solve(far, *shapes())); });
  EXPECT_TRUE(sentence.starts_with(
      "r.json:/solve/0/runs: expected 20 accurate collisions, but of 40 starts under "
      "{\"speed_percent\":50} only "))
      << sentence;
}

TEST(RandomSpin, LimitsAndPlaceAreChecked) {
  const std::string limits = "/imposed/random_spin/b";
  EXPECT_EQ(
      response_refusal("", {}, limits + "/most_rad_s", json::array({0, -1, 0})),
      "s.json:/imposed/random_spin/b/most_rad_s/1: expected at least least_rad_s, which is 0, "
      "got -1");
  EXPECT_EQ(
      response_refusal("", {}, "/imposed/no_spin", true),
      "s.json:/imposed/random_spin/on: expected false where no_spin keeps bodies from turning");
  EXPECT_EQ(response_refusal("", {}, "/meeting/offset_deg", json::array({9, 9})),
            "s.json:/meeting/offset_deg: expected bodies that touch, but they pass by, got [9,9]");
}

}  // namespace impetus::response_study_test
