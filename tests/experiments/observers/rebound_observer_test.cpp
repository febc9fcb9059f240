// The study of distorted rebounds: what is shown of it, and who notices.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <string>

#include "experiments/protocol/observer_file.hpp"
#include "tests/engine/builders.hpp"
#include "tests/experiments/test_scenes.hpp"

namespace impetus::rebound_observer_test {

json scene_with(const std::string& change, double amount) {
  json scene = json::parse(shipped("stimuli/distorted-rebounds.json"));
  scene["imposed"]["rebound"] = {{"change", change}, {"amount", amount}};
  return scene;
}

/// Both velocities after all of it was shown, degrees a second.
std::pair<Vector3, Vector3> parting(const std::string& change, double amount) {
  StagedScene scene = built(scene_with(change, amount));
  bool met = false;
  for (int step = 0; step < 300; ++step) {
    met = !step_whole(scene.world, 1.0 / scene.step_hz).collisions.empty() || met;
  }
  EXPECT_TRUE(met);
  const double m_per_deg = metres_per_degree(scene.viewer.screen.viewing_distance_m);
  return {velocity(scene.world.models()[0], scene.world.states()[0]) / m_per_deg,
          velocity(scene.world.models()[1], scene.world.states()[1]) / m_per_deg};
}

double angle_deg(const std::pair<Vector3, Vector3>& ways) {
  return degrees(atan2_rad(ways.first.cross(ways.second).norm(), ways.first.dot(ways.second)));
}

TEST(DistortedRebounds, PartAtARightAngleAndAsMuchWiderOrNarrowerAsIsAskedFor) {
  const double plain = angle_deg(parting("wider", 0.0));
  EXPECT_NEAR(plain, 90.0, 1.0);
  for (const double amount : {5.0, 40.0, 80.0}) {
    EXPECT_NEAR(angle_deg(parting("wider", amount)), plain + amount, 1e-6);
    EXPECT_NEAR(angle_deg(parting("narrower", amount)), plain - amount, 1e-6);
  }
}

TEST(DistortedRebounds, PartAsMuchFasterOrSlowerAsIsAskedFor) {
  const auto [a, b] = parting("faster", 0.0);
  EXPECT_GT(a.norm(), 5.0);
  const auto [fast_a, fast_b] = parting("faster", 50.0);
  EXPECT_LT((fast_a - 1.5 * a).norm() + (fast_b - 1.5 * b).norm(), 1e-9);
  const auto [slow_a, slow_b] = parting("slower", 80.0);
  EXPECT_LT((slow_a - 0.2 * a).norm() + (slow_b - 0.2 * b).norm(), 1e-9);
}

TEST(DistortedRebounds, StayInTheScreensPlaneWhereverOneLooksFrom) {
  json scene = scene_with("wider", 60.0);
  scene["viewer"]["azimuth_deg"] = 35;
  const StagedScene staged = built(scene);
  const Vector3 to_eye = staged.viewer.eye.normalized();
  EXPECT_LT((staged.world.settings().imposed_rebound->axis - to_eye).norm(), 1e-12);
}

TEST(DistortedRebounds, ThatCannotBeAreRefused) {
  json slower = scene_with("slower", 120);
  EXPECT_EQ(scene_refusal(slower),
            "/imposed/rebound/amount: expected 100 percent slower at most, got 120.0");
  json nobody = json::parse(shipped("stimuli/l-blocks-in-a-cube.json"));
  nobody["imposed"]["rebound"] = {{"change", "wider"}, {"amount", 1}};
  EXPECT_EQ(scene_refusal(nobody), "/imposed/rebound: expected none where no two bodies meet");
}

/// How clearly the shipped participant, who is like the mean of the group, notices a change.
double seen(const std::string& change, double amount) {
  const StagedScene scene = built(scene_with(change, amount));
  json observer = json::parse(shipped("experiments/observers/distorted-rebounds.json"));
  observer["parameters"]["threshold_sd_log10"]["value"] = 0.0;
  const TemporaryFolder folder;
  const ObserverFile file =
      load_observer(folder.write("o.json", observer.dump()).string(), "protocols/causality.json");
  const std::string name = "S01";
  VirtualClock clock;
  const auto one = make_observer(file, {1, name, clock, clock});
  AttemptRecord shown;
  shown.frames.emplace_back();
  CollisionRecord met;
  met.report.bodies = {0, 1};
  shown.collisions.push_back(met);
  one->witnessed(shown, scene);
  return one->seen_in_intervals().back();
}

TEST(ReboundObserver, HasAThresholdForEachChange) {
  EXPECT_NEAR(seen("wider", 40), 0.5, 1e-9);
  EXPECT_NEAR(seen("narrower", 24), 0.5, 1e-9);
  EXPECT_NEAR(seen("faster", 60), 0.5, 1e-9);
  EXPECT_NEAR(seen("slower", 36), 0.5, 1e-9);
  EXPECT_EQ(seen("wider", 0), 0.0);
  EXPECT_GT(seen("narrower", 60), 0.99);
}

}  // namespace impetus::rebound_observer_test
