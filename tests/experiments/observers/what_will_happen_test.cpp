// The clips of "What will happen?" (after Bear et al. 2021): what is asked is not to be seen yet,
// as often yes as no, and a simulated group is about as good as people were.
// SPDX-License-Identifier: MIT
#include "engine/numerics/random_stream.hpp"
#include "experiments/files/protocol_files.hpp"
#include "experiments/observers/imagining/imagined_runs.hpp"
#include "experiments/protocol/protocol_scenes.hpp"
#include "experiments/protocol/screen_file.hpp"
#include "experiments/run/touching.hpp"
#include "experiments/scenes/scene_file.hpp"
#include "tests/experiments/program.hpp"
#include "tests/experiments/test_study.hpp"

namespace impetus::what_will_happen_test {

const NamedPair kAsked{"red", "yellow"};

struct Clip {
  Condition condition;
  StagedScene scene;
};

std::vector<Clip> staged(const Protocol& protocol, const std::vector<Condition>& conditions) {
  const ProtocolScenes scenes(protocol, kUnroundedHold);
  std::vector<Clip> clips;
  for (const Condition& condition : conditions) {
    clips.push_back({condition, scenes.stage(condition, assumed_screen())});
  }
  return clips;
}

const Protocol& protocol() {
  static const Protocol study = load_protocol(source_file("protocols/what-will-happen.json"));
  return study;
}

bool touch_while_shown(StagedScene scene) {
  scene.unseen_s = 0.0;
  return touch_by_the_end(scene, kAsked);
}

TEST(WhatWillHappen, ClipsAreHiddenBeforeAnythingIsToBeSeenOfIt) {
  for (const Clip& clip : staged(protocol(), cells(protocol().design))) {
    StagedScene earlier = clip.scene;
    earlier.unseen_s = 0.3;
    EXPECT_FALSE(touch_while_shown(clip.scene)) << to_text(clip.condition[1].value);
    EXPECT_FALSE(touch_by_the_end(earlier, kAsked)) << to_text(clip.condition[1].value);
    EXPECT_EQ(clip.scene.duration_s, 3.5);
  }
}

TEST(WhatWillHappen, YesIsRightAboutAsOftenAsNo) {
  std::map<std::string, int> yes;
  for (const Clip& clip : staged(protocol(), cells(protocol().design))) {
    yes[to_text(clip.condition[0].value)] += touch_by_the_end(clip.scene, kAsked) ? 1 : 0;
  }
  EXPECT_EQ(yes["collide"], 8);  // of 15
  EXPECT_EQ(yes["drop"], 7);
  int of_practice = 0;
  for (const Clip& clip : staged(protocol(), protocol().design.practice)) {
    of_practice += touch_by_the_end(clip.scene, kAsked) ? 1 : 0;
  }
  EXPECT_EQ(of_practice, 5);  // of 10
}

TEST(WhatWillHappen, WithoutNoiseTheImaginedIsWhatHappens) {
  for (const Clip& clip : staged(protocol(), protocol().design.practice)) {
    RandomStream draws(1, "still");
    const double share = imagined_touching(clip.scene, last_shown_instant(clip.scene), {0, 1},
                                           {1, 0.0, clip.scene.step_hz}, draws);
    EXPECT_EQ(share, touch_by_the_end(clip.scene, kAsked) ? 1.0 : 0.0);
  }
}

TEST(WhatWillHappen, TheLessSteadyTheHeadingTheLessCertain) {
  const Clip clip = staged(protocol(), {protocol().design.practice.front()}).front();
  double last = 1.0;
  for (const double noise_deg : {0.0, 4.0, 40.0}) {
    RandomStream draws(1, "noise");
    const double share = imagined_touching(clip.scene, last_shown_instant(clip.scene), {0, 1},
                                           {100, noise_deg, 50.0}, draws);
    EXPECT_LE(share, last) << noise_deg;
    last = share;
  }
  EXPECT_LT(last, 0.5);
}

TEST(WhatWillHappen, SimulatedGroupsAreAboutAsGoodAsPeopleWere) {
  const TemporaryFolder folder;
  const ProgramResult result =
      run_program(folder, {"run", source_file("protocols/what-will-happen.json").string(), "--db",
                           "a.sqlite", "--participants", "2", "--observer",
                           source_file("experiments/observers/what-will-happen.json").string()});
  ASSERT_EQ(result.status, 0) << result.errors;
  const auto accuracy = [&](const std::string& scenario) {
    return std::stod(value_of(folder / "a.sqlite",
                              "SELECT avg(correct) FROM trial_response WHERE phase = 'main' AND "
                              "condition ->> 'scenario' = '" +
                                  scenario + "'"));
  };
  // Bear et al. 2021: .81 and .75 of their people. Of 150 answers the standard error is .035.
  EXPECT_NEAR(accuracy("collide"), 0.81, 0.1);
  EXPECT_NEAR(accuracy("drop"), 0.75, 0.1);
  // The cross: drawn anew for each trial, from 30 to 90 frames.
  const auto crosses = [&](const std::string& of) {
    return std::stoi(value_of(folder / "a.sqlite",
                              "SELECT " + of +
                                  " FROM (SELECT count(*) AS frames FROM frame WHERE phase = "
                                  "'fixation' GROUP BY attempt_id)"));
  };
  EXPECT_EQ(crosses("min(frames)"), 30);
  EXPECT_EQ(crosses("max(frames)"), 90);
  EXPECT_GT(crosses("count(DISTINCT frames)"), 55);
}

}  // namespace impetus::what_will_happen_test
