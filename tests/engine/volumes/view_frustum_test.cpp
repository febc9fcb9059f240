// The view frustum as an enclosure: its walls against planes worked out another way, and bodies
// that stay in view.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/dynamics/motion.hpp"
#include "tests/engine/builders.hpp"
#include "tests/engine/one_of_each_kind.hpp"

namespace impetus::view_frustum_test {

constexpr std::uint64_t kSeed = 61;

Viewer any_viewer(RandomStream& random) {
  const ScreenGeometry screen{uniform_in(random, 0.3, 2.0), uniform_in(random, 0.3, 2.0), 1280,
                              1024, uniform_in(random, 0.5, 3.0)};
  return viewer_at(screen, uniform_in(random, -180.0, 180.0));
}

ViewFrustum any_frustum(RandomStream& random) {
  const Viewer viewer = any_viewer(random);
  const double front_m = uniform_in(random, -0.1, 0.9) * viewer.screen.viewing_distance_m;
  return view_frustum(viewer, front_m, uniform_in(random, 0.2, 2.0));
}

/// Three corners of each wall, anticlockwise as seen from inside.
constexpr std::array<std::array<int, 3>, 6> kWallCorners{
    {{1, 5, 3}, {0, 2, 4}, {2, 3, 6}, {0, 4, 1}, {0, 1, 2}, {4, 6, 5}}};

/// How far `point` lies beyond the plane through three corners of the wall.
double beyond(const ViewFrustum& frustum, int wall, const Vector3& point) {
  const auto& [p, q, r] = kWallCorners[static_cast<std::size_t>(wall)];
  const Vector3 origin = corner(frustum, p);
  const Vector3 side = (corner(frustum, q) - origin).cross(corner(frustum, r) - origin);
  const Vector3 outward = side.normalized();
  const double sign = outward.dot(origin - corner(frustum, 7 - p)) > 0.0 ? 1.0 : -1.0;
  return sign * outward.dot(point - origin);
}

TEST(ViewFrustum, ItsFrontAndBackFillTheScreen) {
  RandomStream random(kSeed, "corners");
  for (int trial = 0; trial < 100; ++trial) {
    const Viewer viewer = any_viewer(random);
    const ViewFrustum frustum = view_frustum(viewer, 0.3, 0.7);
    for (int index = 0; index < 8; ++index) {
      const auto seen = projected(viewer, corner(frustum, index));
      ASSERT_TRUE(seen);
      EXPECT_NEAR(std::abs(seen->x_m), 0.5 * viewer.screen.width_m, 1e-14);
      EXPECT_NEAR(std::abs(seen->y_m), 0.5 * viewer.screen.height_m, 1e-14);
      EXPECT_EQ(seen->x_m > 0.0, (index & 1) != 0);
      EXPECT_EQ(seen->y_m > 0.0, (index & 2) != 0);
      const double before_m = corner(frustum, index).dot(viewer.eye.normalized());
      EXPECT_NEAR(before_m, (index & 4) != 0 ? -0.7 : 0.3, 1e-14);
    }
  }
}

TEST(ViewFrustum, EachVolumeReachesBeyondAWallAsFarAsItsFurthestPoint) {
  RandomStream random(kSeed, "reach");
  int touched = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const ViewFrustum frustum = any_frustum(random);
    for (const Volume& volume : one_of_each_kind(random, random_in_cube(random, 0.8), 0.3)) {
      double furthest_m = -1e9;
      for (int wall = 0; wall < kWallCount; ++wall) {
        const Core core = cored(volume).core;
        double reach_m = -1e9;
        for (int index = 0; index < 1 << core.dimension; ++index) {
          Vector3 place = core.centre;
          for (int axis = 0; axis < core.dimension; ++axis) {
            place += ((index >> axis & 1) != 0 ? 1.0 : -1.0) * core.half_m[axis] *
                     Vector3(core.axes.col(axis));
          }
          reach_m = std::max(reach_m, beyond(frustum, wall, place) + cored(volume).radius_m);
        }
        ASSERT_NEAR(reach_beyond(frustum, wall, volume), reach_m, 1e-13) << "seed " << kSeed;
        const TouchPoint touch = touch_wall(frustum, wall, volume);
        EXPECT_EQ(touch.depth_m, reach_beyond(frustum, wall, volume));
        EXPECT_EQ(touch.normal, inward_normal(frustum, wall));
        EXPECT_NEAR(beyond(frustum, wall, touch.point), 0.0, 1e-13) << "on the wall";
        EXPECT_NEAR(beyond(frustum, wall, touch.point - touch.normal), 1.0, 1e-13);
        furthest_m = std::max(furthest_m, reach_m);
      }
      ASSERT_EQ(reaches_wall(frustum, volume), furthest_m > 0.0) << "seed " << kSeed;
      touched += furthest_m > 0.0 ? 1 : 0;
    }
  }
  EXPECT_GT(touched, 100);
  EXPECT_LT(touched, 1'700);
}

TEST(ViewFrustum, ASphereIsTreatedAsTheVolumeItIs) {
  RandomStream random(kSeed, "spheres");
  for (int trial = 0; trial < 300; ++trial) {
    const ViewFrustum frustum = any_frustum(random);
    const Sphere sphere{random_in_cube(random, 1.0), uniform_in(random, 0.01, 0.3)};
    ASSERT_EQ(reaches_wall(frustum, sphere), reaches_wall(frustum, Volume(sphere)));
    for (int wall = 0; wall < kWallCount; ++wall) {
      const TouchPoint touch = touch_wall(frustum, wall, sphere);
      ASSERT_EQ(touch.point, touch_wall(frustum, wall, Volume(sphere)).point);
      ASSERT_EQ(reach_beyond(frustum, wall, sphere), reach_beyond(frustum, wall, Volume(sphere)));
      ASSERT_NEAR((touch.point - sphere.centre).norm(),
                  std::abs(beyond(frustum, wall, sphere.centre)), 1e-13);
    }
  }
}

TEST(ViewFrustum, WhateverIsNotSeenLiesBeyondAWall) {
  RandomStream random(kSeed, "unseen");
  int behind_eye = 0;
  for (int trial = 0; trial < 10'000; ++trial) {
    const Viewer viewer = viewer_at({0.4, 0.3, 1280, 1024, 0.6}, uniform_in(random, 0.0, 360.0));
    const ViewFrustum frustum = view_frustum(viewer, 0.5, 1.0);
    const Vector3 place = random_in_cube(random, 2.0);
    const auto image = projected(viewer, place);
    const bool seen = image && std::abs(image->x_m) < 0.2 && std::abs(image->y_m) < 0.15;
    ASSERT_TRUE(seen || reaches_wall(frustum, Sphere{place, 0.0})) << "seed " << kSeed;
    behind_eye += image ? 0 : 1;
  }
  EXPECT_GT(behind_eye, 1'000);
}

TEST(ViewFrustum, ABallIsReflectedByEachWallAndKeepsItsEnergy) {
  const BodyModel model = ball(0.05, 2.0);
  const Viewer viewer = viewer_at({1.0, 0.8, 1280, 1024, 2.0}, 30.0);
  const ViewFrustum frustum = view_frustum(viewer, 0.4, 0.6);
  for (int wall = 0; wall < kWallCount; ++wall) {
    const Vector3 inward = inward_normal(frustum, wall);
    const Vector3 across = inward.cross(Vector3(0.3, 0.5, 0.7));
    WorldSettings settings;
    settings.enclosure = frustum;
    const double room_m = -reach_beyond(frustum, wall, Sphere{Vector3::Zero(), 0.05});
    const Vector3 start = (0.001 - room_m) * inward;
    World world({model}, {moving(model, start, across - 2.0 * inward)}, settings);
    const double energy = total_energy(world);
    const StepReport report = step_whole(world);
    ASSERT_EQ(report.collisions.size(), 1U) << wall;
    EXPECT_EQ(report.collisions[0].bodies, (BodyPair{0, wall_index(wall)}));
    EXPECT_NEAR(report.collisions[0].approach_m_s, 2.0, 1e-14);
    EXPECT_LT((velocity(model, world.states()[0]) - across - 2.0 * inward).norm(), 1e-14);
    EXPECT_NEAR(total_energy(world), energy, 1e-14 * energy);
  }
}

TEST(ViewFrustum, BodiesStayInViewAndGainNoEnergyInAnyImpact) {
  RandomStream random(kSeed, "crowd in view");
  const BodyModel model = solid_body(small_l_block(), 3);
  const Viewer viewer = viewer_at({1.6, 1.2, 1280, 1024, 2.5}, 20.0);
  std::vector<BodyState> states;
  for (int i = 0; i < 6; ++i) {
    const Vector3 place(0.36 * (i % 3 - 1), 0.36 * (i / 3) - 0.18, 0.0);
    states.push_back(moving(model, place, random_in_cube(random, 1.0)));
    states.back().angular_momentum = model.inverse_inertia.inverse() * random_in_cube(random, 3.0);
  }
  WorldSettings settings;
  settings.enclosure = view_frustum(viewer, 0.4, 0.4);
  World world(std::vector<BodyModel>(6, model), states, settings);
  std::array<int, 6> hits{};
  for (int step = 0; step < 4'800; ++step) {
    const double before = energy_after_free_flight(world, kStep_s);
    for (const CollisionReport& collision : step_whole(world).collisions) {
      if (is_wall(collision.bodies.b)) {
        ++hits[static_cast<std::size_t>(kEnclosure - collision.bodies.b)];
      }
    }
    ASSERT_LE(total_energy(world), before * (1.0 + 1e-13)) << step;
    for (const BodyState& state : world.states()) {
      const auto image = projected(viewer, state.pose.position);
      ASSERT_TRUE(image) << step;
      ASSERT_LT(std::abs(image->x_m), 0.8) << step;
      ASSERT_LT(std::abs(image->y_m), 0.6) << step;
    }
  }
  EXPECT_GT(*std::min_element(hits.begin(), hits.end()), 5) << "every wall was met";
}

TEST(ViewFrustum, OneThatHoldsNothingIsRefused) {
  const ViewFrustum good = view_frustum(viewer_at({0.4, 0.3, 1280, 1024, 0.6}, 0.0), 0.2, 0.3);
  const auto refusal = [&](auto change) -> std::string {
    WorldSettings settings;
    ViewFrustum changed = good;
    change(changed);
    settings.enclosure = changed;
    try {
      const World world({}, {}, settings);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_EQ(refusal([](ViewFrustum&) {}), "accepted");
  const std::string size = "world: a view frustum needs a screen of positive width and height";
  EXPECT_EQ(refusal([](ViewFrustum& f) { f.half_width_m = 0.0; }), size);
  EXPECT_EQ(refusal([](ViewFrustum& f) { f.half_height_m = std::nan(""); }), size);
  EXPECT_EQ(refusal([](ViewFrustum& f) { f.front_m = 0.6; }),
            "world: a view frustum needs a front between the screen and the eye");
  EXPECT_EQ(refusal([](ViewFrustum& f) { f.back_m = -0.2; }),
            "world: a view frustum needs a back behind its front");
  const std::string axes =
      "world: a view frustum needs a screen that faces the eye, with unit axes at right angles";
  EXPECT_EQ(refusal([](ViewFrustum& f) { f.up = f.right; }), axes);
  EXPECT_EQ(refusal([](ViewFrustum& f) { f.right *= 2.0; }), axes);
  EXPECT_EQ(refusal([](ViewFrustum& f) { f.eye.setZero(); }), axes);
}

}  // namespace impetus::view_frustum_test
