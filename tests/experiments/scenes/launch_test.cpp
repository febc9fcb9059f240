// A launch that is imposed: where the first stops, against a polygon's distance found by bisection;
// when the second moves off, and when it appears.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <vector>

#include "experiments/observers/shown_truths.hpp"
#include "experiments/record/ports.hpp"
#include "experiments/run/scene_run.hpp"
#include "tests/experiments/test_scenes.hpp"

namespace impetus::launch_test {

json odd_shapes() { return json::parse(shipped("stimuli/odd-shapes.json")); }

json with(json scene, const std::string& pointer, json value) {
  return changed(std::move(scene), pointer, std::move(value));
}

using Point = std::array<double, 2>;

/// Whether a disc comes within a polygon: its centre's distance from every side.
bool touches(const std::vector<Point>& polygon, const Point& centre, double radius) {
  double least = 1e9;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d a(polygon[i].data());
    const Eigen::Vector2d b(polygon[(i + 1) % polygon.size()].data());
    const Eigen::Vector2d c(centre.data());
    const double share = std::clamp((c - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
    least = std::min(least, (c - (a + share * (b - a))).norm());
  }
  return least <= radius;
}

/// The polygon about its centroid, as a body has it.
std::vector<Point> about_centroid(const json& outline) {
  double area = 0.0;
  Point centroid{0.0, 0.0};
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Point a = outline[i];
    const Point b = outline[(i + 1) % outline.size()];
    const double cross = a[0] * b[1] - b[0] * a[1];
    area += 0.5 * cross;
    for (int k = 0; k < 2; ++k) {
      centroid[k] += (a[k] + b[k]) * cross / 6.0;
    }
  }
  std::vector<Point> polygon;
  for (const Point corner : outline) {
    polygon.push_back({corner[0] - centroid[0] / area, corner[1] - centroid[1] / area});
  }
  return polygon;
}

/// Where a disc of 20 px that comes from the left along y = 0 first touches, by bisection of a
/// scan.
double first_touch_px(const std::vector<Point>& polygon) {
  double apart = -200.0;
  while (!touches(polygon, {apart + 0.5, 0.0}, 20.0)) {
    apart += 0.5;
  }
  double near = apart + 0.5;
  for (int i = 0; i < 40; ++i) {
    (touches(polygon, {0.5 * (apart + near), 0.0}, 20.0) ? near : apart) = 0.5 * (apart + near);
  }
  return near;
}

double px(const StagedScene& scene, double metres) {
  return 40.0 * metres / metres_per_degree(scene.viewer.screen.viewing_distance_m);
}

TEST(Launch, TheFirstStopsWithTheGapThatIsAskedForLeftBetweenTheOutlines) {
  const json sets =
      json::parse(shipped("protocols/odd-shapes.json"))["design"]["factors"][0]["sets"];
  ASSERT_EQ(sets.size(), 16U);
  for (const auto& [name, values] : sets.items()) {
    const json& outline = values["/bodies/1/shape/outline_px"];
    for (const double gap_px : {0.0, 20.0}) {
      const StagedScene scene = built(with(
          with(odd_shapes(), "/bodies/1/shape/outline_px", outline), "/launch/gap_px", gap_px));
      const double apart_px =
          px(scene, scene.launch->stops.position.x() - scene.start[1].pose.position.x());
      // The disc is drawn with 128 sides.
      EXPECT_NEAR(apart_px, first_touch_px(about_centroid(outline)) - gap_px, 0.02) << name;
    }
  }
}

TEST(Launch, TheFirstStopsOnItsStepAndTheSecondMovesOffAfterTheHold) {
  SceneRun run(built(with(odd_shapes(), "/launch/gap_px", -12)));
  const Launch launch = *run.scene().launch;
  const auto x_of = [&](std::size_t body) {
    return px(run.scene(), run.world().states()[body].pose.position.x());
  };
  const double second_px = x_of(1);
  const auto step_until = [&](double time_s) {
    while (static_cast<double>(run.number()) < time_s * 240.0 - 1e-6) {
      EXPECT_TRUE(run.step_whole().collisions.empty()) << "they pass through each other";
    }
  };
  step_until(3.0);
  EXPECT_NEAR(x_of(0), px(run.scene(), launch.stops.position.x()), 1e-6);
  const double stopped_px = x_of(0);
  step_until(3.0 + 2.0 / 60.0);
  EXPECT_EQ(x_of(0), stopped_px);
  EXPECT_EQ(x_of(1), second_px);
  step_until(4.0 + 2.0 / 60.0);
  EXPECT_EQ(x_of(0), stopped_px);
  EXPECT_NEAR(x_of(1), second_px + 60.0, 1e-6);
  EXPECT_EQ(run.ends_s(), 3.0 + 2.0 / 60.0 + 1.5);
}

TEST(Launch, BothMoveAlongItsDirection) {
  const StagedScene scene = built(with(odd_shapes(), "/launch/direction_deg", 90));
  EXPECT_NEAR(scene.launch->along.y(), 1.0, 1e-15);
  EXPECT_NEAR(px(scene, scene.launch->stops.position.y() - scene.start[0].pose.position.y()), 180.0,
              1e-9);
}

TEST(Launch, TheSecondIsNotSeenUntilTheFirstIsNear) {
  const StagedScene scene = built(odd_shapes());
  const double appears_s = 3.0 - 125.0 / 60.0;
  std::vector<Pose> poses{scene.start[0].pose, scene.start[1].pose};
  EXPECT_EQ(picture_of(scene, poses, appears_s - 0.01, {}).bodies[1].look.mesh, nullptr);
  EXPECT_NE(picture_of(scene, poses, appears_s + 0.01, {}).bodies[1].look.mesh, nullptr);
  EXPECT_NE(picture_of(scene, poses, 0.0, {}).bodies[0].look.mesh, nullptr);
}

TEST(Launch, AHollowIsSeenLessDeepByCoarserBounds) {
  const json sets =
      json::parse(shipped("protocols/odd-shapes.json"))["design"]["factors"][0]["sets"];
  const StagedScene scene = built(with(odd_shapes(), "/bodies/1/shape/outline_px",
                                       sets["H concave"]["/bodies/1/shape/outline_px"]));
  EXPECT_NEAR(launch_gap_arcmin(scene, std::nullopt), 0.0, 1e-9);
  const double coarse = launch_gap_arcmin(scene, 0);
  const double fine = launch_gap_arcmin(scene, 4);
  EXPECT_LT(coarse, -60.0 * 15.0 / 40.0) << "its hull is 21 px nearer";
  EXPECT_GT(fine, 0.5 * coarse);
  EXPECT_LT(fine, 0.0);
}

TEST(Launch, SaysWhatIsWrongWithIt) {
  const json scene = odd_shapes();
  EXPECT_EQ(scene_refusal(with(scene, "/launch/first", "nobody")),
            "/launch/first: expected the name of a body, got \"nobody\"");
  EXPECT_EQ(scene_refusal(with(scene, "/launch/second", "agent")),
            "/launch/second: expected another body than the first, got \"agent\"");
  EXPECT_EQ(scene_refusal(with(scene, "/bodies/0/shape", {{"kind", "sphere"}, {"radius_px", 9}})),
            "/launch/first: expected a body that is a disc, a prism or a box, got sphere");
  EXPECT_EQ(scene_refusal(with(scene, "/bodies/0/position_px", {1, 2})),
            "/bodies/0: expected no position for the first body of the launch, which follows from "
            "it");
  EXPECT_EQ(scene_refusal(with(scene, "/bodies/1/velocity_px_s", {1, 2})),
            "/bodies/1/velocity_px_s: expected none for a body of the launch, got [1,2]");
  EXPECT_EQ(scene_refusal(with(scene, "/bodies/1/fixed", true)),
            "/launch/second: expected a body that is not fixed, got \"patient\"");
  EXPECT_EQ(scene_refusal(with(scene, "/duration_s", 2)),
            "/duration_s: expected none beside a launch, which lasts from lead_s to follow_s");
  EXPECT_EQ(scene_refusal(with(scene, "/launch/lead_s", 1.001)),
            "/launch/lead_s: expected a whole number of steps of 1/240 s, got 1.001");
  json still = scene;
  still.erase("imposed");
  EXPECT_EQ(scene_refusal(still),
            "/imposed: expected the key \"contact_hold_ms\" for the launch, which is missing");
}

}  // namespace impetus::launch_test
