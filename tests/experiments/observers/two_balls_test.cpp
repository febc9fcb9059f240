// The eighteen clips of two balls and a gate (Gerstenberg et al. 2021), against a computation of
// discs in a plane that knows nothing of the engine: from impact to impact, in closed form.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <vector>

#include "engine/numerics/elementary_functions.hpp"
#include "engine/numerics/random_stream.hpp"
#include "experiments/files/protocol_files.hpp"
#include "experiments/observers/imagining/counterfactual_observer.hpp"
#include "experiments/protocol/protocol_scenes.hpp"
#include "experiments/protocol/screen_file.hpp"
#include "experiments/run/scene_run.hpp"
#include "experiments/scenes/scene_file.hpp"
#include "tests/experiments/command_lines.hpp"
#include "tests/experiments/program.hpp"
#include "tests/experiments/test_study.hpp"

namespace impetus::two_balls_test {

constexpr double kRadius_px = 30.0;
constexpr double kNever = std::numeric_limits<double>::infinity();

/// A disc in the plane: px and px/s.
struct Disc {
  Eigen::Vector2d at;
  Eigen::Vector2d velocity;
};

/// When two discs first touch, from now on.
double touching_s(const Disc& a, const Disc& b, double reach_px) {
  const Eigen::Vector2d apart = b.at - a.at;
  const Eigen::Vector2d closing = b.velocity - a.velocity;
  const double speed2 = closing.squaredNorm();
  const double approach = apart.dot(closing);
  const double root = approach * approach - speed2 * (apart.squaredNorm() - reach_px * reach_px);
  return approach < 0.0 && root > 0.0 ? (-approach - std::sqrt(root)) / speed2 : kNever;
}

/// A wall as its corners, and its sides moved out by a radius.
struct Wall {
  double left, right, bottom, top;
};
constexpr std::array<Wall, 4> kWalls{
    {{0, 800, 580, 600}, {0, 800, 0, 20}, {0, 20, 400, 580}, {0, 20, 20, 200}}};

/// An impact on something that stands still, and its normal.
struct Impact {
  double after_s{kNever};
  Eigen::Vector2d normal{Eigen::Vector2d::Zero()};
  void take(double s, const Eigen::Vector2d& along) {
    if (s < after_s) {
      *this = {s, along};
    }
  }
};

Impact next_impact(const Disc& disc) {
  Impact next;
  for (const Wall& wall : kWalls) {
    for (const double x : {wall.left, wall.right}) {
      const double side = x == wall.left ? -1.0 : 1.0;
      const double s = (x + side * kRadius_px - disc.at.x()) / disc.velocity.x();
      const double y = disc.at.y() + s * disc.velocity.y();
      if (disc.velocity.x() * side < 0.0 && s > 0.0 && y >= wall.bottom && y <= wall.top) {
        next.take(s, {side, 0.0});
      }
    }
    for (const double y : {wall.bottom, wall.top}) {
      const double side = y == wall.bottom ? -1.0 : 1.0;
      const double s = (y + side * kRadius_px - disc.at.y()) / disc.velocity.y();
      const double x = disc.at.x() + s * disc.velocity.x();
      if (disc.velocity.y() * side < 0.0 && s > 0.0 && x >= wall.left && x <= wall.right) {
        next.take(s, {0.0, side});
      }
    }
    for (const double x : {wall.left, wall.right}) {
      for (const double y : {wall.bottom, wall.top}) {
        const Disc corner{{x, y}, {0.0, 0.0}};
        const double s = touching_s(corner, disc, kRadius_px);
        if (s > 0.0 && s < kNever) {
          next.take(s, (disc.at + s * disc.velocity - corner.at) / kRadius_px);
        }
      }
    }
  }
  return next;
}

/// What becomes of discs, the last of which is B.
struct Course {
  bool through{false};
  double first_s{kNever};           ///< when anything is first touched
  double first_contact_s{kNever};   ///< of A and B
  double second_s{kNever};          ///< of whatever comes next
  std::vector<Disc> after_contact;  ///< at the first contact, with the velocities after it
};

Course computed(std::vector<Disc> discs, double until_s) {
  Course course;
  double now_s = 0.0;
  while (now_s < until_s) {
    const double line_s = (-30.0 - discs.back().at.x()) / discs.back().velocity.x();
    const double passes_s = discs.back().velocity.x() < 0.0 && line_s > 0.0 ? line_s : kNever;
    std::vector<Impact> impacts;
    double step_s = std::min(passes_s, until_s - now_s);
    for (const Disc& disc : discs) {
      impacts.push_back(next_impact(disc));
      step_s = std::min(step_s, impacts.back().after_s);
    }
    const double meet_s =
        discs.size() == 2 ? touching_s(discs[0], discs[1], 2.0 * kRadius_px) : kNever;
    step_s = std::min(step_s, meet_s);
    now_s += step_s;
    for (Disc& disc : discs) {
      disc.at += step_s * disc.velocity;
    }
    course.first_s = std::min(course.first_s, now_s);
    if (step_s == passes_s) {
      course.through = true;
      course.second_s = std::min(course.second_s, now_s);
      return course;
    }
    for (std::size_t i = 0; i < discs.size(); ++i) {
      if (impacts[i].after_s == step_s) {
        discs[i].velocity -= 2.0 * impacts[i].normal.dot(discs[i].velocity) * impacts[i].normal;
      }
    }
    if (course.first_contact_s < kNever && course.second_s == kNever) {
      course.second_s = now_s;
    }
    if (meet_s == step_s) {
      const Eigen::Vector2d normal = (discs[1].at - discs[0].at).normalized();
      const double exchanged = normal.dot(discs[1].velocity - discs[0].velocity);
      discs[0].velocity += exchanged * normal;
      discs[1].velocity -= exchanged * normal;
      if (course.first_contact_s == kNever) {
        course.first_contact_s = now_s;
        course.after_contact = discs;
      }
    }
  }
  return course;
}

/// One clip, staged, and the discs that it begins with.
struct Clip {
  std::string name;
  StagedScene scene;
  std::vector<Disc> discs;
};

Eigen::Vector2d pair_at(const nlohmann::json& values) {
  return {values[0].get<double>(), values[1].get<double>()};
}

const std::vector<Clip>& clips() {
  static const std::vector<Clip> all = [] {
    static const Protocol protocol = load_protocol(source_file("protocols/two-balls.json"));
    const ProtocolScenes scenes(protocol, kUnroundedHold);
    std::vector<Clip> made;
    for (int clip = 1; clip <= 20; ++clip) {
      const Condition condition{{"clip", std::to_string(clip)},
                                {"judgement", std::string("causal")}};
      const nlohmann::json scene = scene_under(protocol, condition);
      std::vector<Disc> discs;
      for (std::size_t body = 0; body < 2; ++body) {
        discs.push_back({pair_at(scene["bodies"][body]["position_px"]),
                         pair_at(scene["bodies"][body]["velocity_px_s"])});
      }
      made.push_back({std::to_string(clip), scenes.stage(condition, assumed_screen()), discs});
    }
    return made;
  }();
  return all;
}

/// Where a body is, in pixels of the plane.
Eigen::Vector2d place_px(const SceneRun& run, std::size_t body) {
  const double px_per_m = 40.0 / metres_per_degree(run.scene().viewer.screen.viewing_distance_m);
  const Vector3& at = run.world().states()[body].pose.position;
  return {400.0 + px_per_m * at.x(), 300.0 + px_per_m * at.y()};
}

TEST(TwoBalls, WhatBecomesOfEachClipIsWhatIsComputedInThePlane) {
  const std::map<int, std::string> told{
      {1, "misses"}, {6, "misses"}, {8, "through"}, {13, "through"}, {18, "through"}};
  for (const Clip& clip : clips()) {
    SCOPED_TRACE("clip " + clip.name);
    EXPECT_EQ(gets_through(clip.scene), computed(clip.discs, 6.0).through);
    EXPECT_EQ(gets_through(clip.scene, 0), computed({clip.discs[1]}, 6.0).through);
    const auto known = told.find(std::stoi(clip.name));
    if (known != told.end()) {
      EXPECT_EQ(gets_through(clip.scene), known->second == "through");
    }
  }
}

TEST(TwoBalls, BallsGoWhereTheClosedFormSaysBeforeTheyMeetAndAfter) {
  for (const Clip& clip : clips()) {
    SCOPED_TRACE("clip " + clip.name);
    const Course course = computed(clip.discs, 6.0);
    ASSERT_LT(course.first_contact_s, 6.0);
    SceneRun run(clip.scene);
    double worst_before_px = 0.0;
    double worst_after_px = 0.0;
    for (double now_s = 0.0; now_s < std::min(run.ends_s(), course.second_s);) {
      run.step_whole();
      now_s = static_cast<double>(run.number()) / clip.scene.step_hz;
      for (std::size_t body = 0; body < 2; ++body) {
        const Disc& start = clip.discs[body];
        if (now_s < course.first_s) {
          worst_before_px = std::max(
              worst_before_px, (place_px(run, body) - start.at - now_s * start.velocity).norm());
        } else if (now_s > course.first_contact_s && now_s < course.second_s) {
          const Disc& met = course.after_contact[body];
          const Eigen::Vector2d expected = met.at + (now_s - course.first_contact_s) * met.velocity;
          worst_after_px = std::max(worst_after_px, (place_px(run, body) - expected).norm());
        }
      }
    }
    EXPECT_LT(worst_before_px, 0.01);
    EXPECT_LT(worst_after_px, 1.0);
  }
}

TEST(TwoBalls, PredictionsHoldStillFromSeedToSeed) {
  const Imagination by{1000, 1.0, 50.0};
  for (const std::size_t place : {2U, 9U, 14U}) {
    const Clip& clip = clips()[place];
    SCOPED_TRACE("clip " + clip.name);
    std::vector<double> shares;
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      RandomStream draws(seed, "seeds");
      shares.push_back(foresee(clip.scene, by, draws).without);
    }
    double mean = 0.0;
    for (const double share : shares) {
      mean += share / static_cast<double>(shares.size());
    }
    for (const double share : shares) {
      EXPECT_NEAR(share, mean, 0.02);
    }
  }
}

TEST(TwoBalls, WithoutNoiseTheImaginedIsWhatWouldHaveBeen) {
  for (const Clip& clip : clips()) {
    RandomStream draws(1, "still");
    const Foresight foresight = foresee(clip.scene, {2, 0.0, 600.0}, draws);
    EXPECT_EQ(foresight.other, std::size_t{0}) << clip.name;
    EXPECT_EQ(foresight.without, gets_through(clip.scene, 0) ? 1.0 : 0.0) << clip.name;
  }
}

TEST(TwoBalls, SimulatedGroupsMarkWhatTheModelSays) {
  const TemporaryFolder folder;
  const ProgramResult result =
      run_program(folder, {"run", source_file("protocols/two-balls.json").string(), "--db",
                           "a.sqlite", "--participants", "4", "--observer",
                           source_file("experiments/observers/two-balls.json").string()});
  ASSERT_EQ(result.status, 0) << result.errors;
  const auto mean = [&](const std::string& judgement, int clip) {
    return std::stod(value_of(
        folder / "a.sqlite",
        "SELECT avg(detail ->> 'value') FROM trial_response WHERE kind = 'slider' AND phase = "
        "'main' AND condition ->> 'judgement' = '" +
            judgement + "' AND condition ->> 'clip' = '" + std::to_string(clip) + "'"));
  };
  EXPECT_GT(mean("counterfactual", 5), 85.0);   // B alone goes straight through
  EXPECT_LT(mean("counterfactual", 14), 15.0);  // and here straight at the wall
  EXPECT_LT(mean("causal", 5), -80.0);          // A prevented it
  EXPECT_GT(mean("causal", 14), 80.0);          // A caused it
  EXPECT_LT(std::abs(mean("causal", 18)), 25.0);
}

TEST(TwoBalls, PredictTellsWhatHappensWhatWouldHaveAndWhatIsExpected) {
  const TemporaryFolder folder;
  const ProgramResult result =
      run_program(folder, {"predict", source_file("protocols/two-balls.json").string(), "--runs",
                           "20", "--paths", "paths.csv"});
  ASSERT_EQ(result.status, 0) << result.errors;
  EXPECT_NE(result.output.find("clip 6     misses        A        through"), std::string::npos)
      << result.output;
  EXPECT_NE(result.output.find("clip 19 "), std::string::npos) << result.output;
  std::ifstream file(folder / "paths.csv");
  std::string head;
  std::string first;
  std::getline(file, head);
  std::getline(file, first);
  EXPECT_EQ(head, "condition,body,time_s,x_px,y_px");
  EXPECT_EQ(first, "\"clip 1\",\"A\",0.000000,830.0000,550.0000");
  expect_refused(
      folder, {"predict", source_file("protocols/two-balls.json").string(), "--paths", "paths.csv"},
      "paths.csv: exists already and is not overwritten");
}

TEST(TwoBalls, PredictRefusesAProtocolWithoutAGoal) {
  const TemporaryFolder folder;
  const ProgramResult result =
      run_program(folder, {"predict", source_file("protocols/causality.json").string()});
  EXPECT_EQ(result.status, 2);
  EXPECT_NE(result.errors.find(":/goal: expected a goal, by which something may come of it"),
            std::string::npos)
      << result.errors;
}

}  // namespace impetus::two_balls_test
