// Contacts of volumes whose answer is known: touching, nested, coincident, parallel, crossing and
// degenerate ones; spheres bit for bit as ever; and the walls of a closed cube.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/volumes/closed_cube.hpp"
#include "tests/engine/random_volumes.hpp"

namespace impetus::volume_contacts_test {

constexpr std::uint64_t kSeed = 42;
constexpr double kRounding = 1e-9;  // of what is shared by cores that touch
const Vector3 kX = Vector3::UnitX();
const Vector3 kY = Vector3::UnitY();
const Vector3 kZ = Vector3::UnitZ();
const Quaternion kUpright = Quaternion::Identity();

void expect_contact(const Volume& a, const Volume& b, const Vector3& normal, double depth_m,
                    const Vector3& point) {
  const TouchPoint contact = touch(a, b, kZ);
  EXPECT_LT((contact.normal - normal).norm(), kRounding) << contact.normal.transpose();
  EXPECT_NEAR(contact.depth_m, depth_m, kRounding);
  EXPECT_LT((contact.point - point).norm(), kRounding) << contact.point.transpose();
  EXPECT_EQ(overlap(a, b), depth_m >= 0.0);
}

TEST(VolumeContact, ParallelSegmentsTouchAtTheMiddleOfTheirOverlap) {
  // Along x from −2 to 2 and from 1 to 5: the overlap's middle is 1.5; radii 0.3 and 0.1 divide
  // the way of 0.35 between the axes in 3 : 1.
  const LineSwept below{{0.0, 0.0, 0.0}, {2.0, 0.0, 0.0}, 0.3};
  const LineSwept above{{3.0, 0.35, 0.0}, {-2.0, 0.0, 0.0}, 0.1};
  expect_contact(below, above, -kY, 0.05, {1.5, 0.2625, 0.0});
}

TEST(VolumeContact, ASegmentAlongARectangleTouchesAtTheMiddleOfWhatLiesOverIt) {
  const LineSwept line{{1.0, 0.0, 0.5}, {2.0, 0.0, 0.0}, 0.25};  // x from −1 to 3
  const RectangleSwept flat{{0.0, 0.0, 0.0}, {2.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, 0.25};
  expect_contact(line, flat, kZ, 0.0, {0.5, 0.0, 0.25});
}

TEST(VolumeContact, ParallelRectanglesTouchAtTheCentroidOfTheirOverlap) {
  // A square, and one of half the diagonal turned by 45° about its corner: they share a triangle
  // with corners (0, 0), (1, 0) and (1, 1), mirrored in the x axis.
  const RectangleSwept square{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, 0.5};
  const RectangleSwept turned{{2.0, 0.0, 0.75}, {1.0, 1.0, 0.0}, {1.0, -1.0, 0.0}, 0.5};
  expect_contact(square, turned, -kZ, 0.25, {2.0 / 3.0, 0.0, 0.375});
}

TEST(VolumeContact, AllButParallelSegmentsTouchWhereTheyAreNearest) {
  const LineSwept level{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, 0.5};
  const LineSwept falling{{0.0, 1.0, 0.0}, {1.0, -0.25, 0.0}, 0.5};
  expect_contact(level, falling, -kY, 0.25, {1.0, 0.375, 0.0});
}

TEST(VolumeContact, CrossingSegmentsPartAcrossBoth) {
  const LineSwept along{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, 0.25};
  const LineSwept across{{0.5, 0.0, 0.0}, {0.0, 1.0, 0.0}, 0.5};
  // The centres tell no sense of z; the fallback does.
  expect_contact(along, across, kZ, 0.75, {0.5, 0.0, 0.0});
}

TEST(VolumeContact, SegmentsOnOneLinePartAcrossItTowardsTheFallback) {
  const LineSwept one{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, 0.25};
  const LineSwept other{{1.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, 0.25};
  const TouchPoint contact = touch(one, other, Vector3(0.6, 0.0, 0.8));
  EXPECT_LT((contact.normal - kZ).norm(), kRounding);
  EXPECT_NEAR(contact.depth_m, 0.5, kRounding);
  EXPECT_LT((contact.point - Vector3(0.5, 0.0, 0.0)).norm(), kRounding);
}

TEST(VolumeContact, CrossingRectanglesPartByTheShortestWay) {
  // A large floor, and a sheet that stands on it and reaches 0.25 below.
  const RectangleSwept floor{{0.0, 0.0, 0.0}, {5.0, 0.0, 0.0}, {0.0, 5.0, 0.0}, 0.125};
  const RectangleSwept sheet{{1.0, 0.0, 0.75}, {0.5, 0.0, 0.0}, {0.0, 0.0, 1.0}, 0.125};
  expect_contact(sheet, floor, kZ, 0.5, {1.0, 0.0, 0.0});
}

TEST(VolumeContact, AStackedBoxTouchesAtTheCentroidOfTheOverlap) {
  const Box below{{0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}, kUpright};
  const Box above{{1.5, 1.0, 1.75}, {1.0, 1.0, 1.0}, kUpright};
  // They share x from 0.5 to 1, y from 0 to 1, z from 0.75 to 1.
  expect_contact(above, below, kZ, 0.25, {0.75, 0.5, 0.875});
}

TEST(VolumeContact, FacesThatTwoBoxesShareCountOnce) {
  const Box wide{{1.0, 1.0, 1.0}, {1.0, 1.0, 1.0}, kUpright};
  const Box long_and_low{{2.5, 1.0, 0.5}, {1.5, 1.0, 0.5}, kUpright};
  // They share x from 1 to 2, y from 0 to 2, z from 0 to 1.
  expect_contact(long_and_low, wide, kX, 1.0, {1.5, 1.0, 0.5});
}

TEST(VolumeContact, TheOverlapOfTwoBoxesHasTheCentroidOfItsSampledPoints) {
  RandomStream random(kSeed, "centroid");
  int compared = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const Box a{random_in_cube(random, 0.5), {1.0, 0.6, 0.8}, random_turn(random)};
    const Box b{random_in_cube(random, 0.5), {0.5, 1.0, 0.3}, random_turn(random)};
    Vector3 sum = Vector3::Zero();
    Vector3 squares = Vector3::Zero();
    int count = 0;
    for (int sample = 0; sample < 10'000; ++sample) {
      const Vector3 shares = random_in_cube(random, 1.0);
      const Vector3 point = b.centre + b.orientation * shares.cwiseProduct(b.half_extents_m);
      if (holds(a, point)) {
        sum += point;
        squares += point.cwiseAbs2();
        ++count;
      }
    }
    if (count < 1'000) {
      continue;
    }
    ++compared;
    const Vector3 mean = sum / count;
    const Vector3 variance = squares / count - mean.cwiseAbs2();
    // Six standard errors of the mean.
    const double allowed_m = 6.0 * std::sqrt(variance.sum() / count);
    ASSERT_LT((touch(a, b, kZ).point - mean).norm(), allowed_m) << "seed " << kSeed;
  }
  EXPECT_GT(compared, 30);
}

TEST(VolumeContact, BoxesThatJustTouchShareAFaceAnEdgeOrACorner) {
  const Box still{{0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}, kUpright};
  const auto beside = [&](double x, double y, double z) {
    return Box{{x, y, z}, {1.0, 1.0, 1.0}, kUpright};
  };
  expect_contact(beside(1.0, 0.0, 2.0), still, kZ, 0.0, {0.5, 0.0, 1.0});
  const TouchPoint edge = touch(beside(2.0, 1.0, 2.0), still, kZ);
  EXPECT_LT((edge.point - Vector3(1.0, 0.5, 1.0)).norm(), kRounding);
  const TouchPoint corner = touch(beside(2.0, 2.0, 2.0), still, kZ);
  EXPECT_LT((corner.point - Vector3(1.0, 1.0, 1.0)).norm(), kRounding);
  EXPECT_TRUE(overlap(beside(2.0, 2.0, 2.0), still));
  EXPECT_FALSE(overlap(beside(2.0, 2.0, std::nextafter(2.0, 3.0) + 1e-9), still));
}

TEST(VolumeContact, BoxesEdgeToEdgePartAlongTheProductOfTheEdges) {
  // Edges along x at z = 0 and along y at z = −0.1, each the ridge of a box turned by 45°.
  const double c = std::sqrt(0.5);
  const Quaternion about_x(std::cos(std::numbers::pi / 8.0), std::sin(std::numbers::pi / 8.0), 0.0,
                           0.0);
  const Quaternion about_y(std::cos(std::numbers::pi / 8.0), 0.0, std::sin(std::numbers::pi / 8.0),
                           0.0);
  const Box ridge_along_x{{0.0, 0.0, -2.0 * c}, {3.0, 1.0, 1.0}, about_x};
  const Box ridge_along_y{{0.0, 0.0, 2.0 * c - 0.1}, {1.0, 3.0, 1.0}, about_y};
  const TouchPoint contact = touch(ridge_along_y, ridge_along_x, kX);
  EXPECT_NEAR(contact.depth_m, 0.1 + 2.0 * (std::sqrt(2.0) - 2.0 * c), kRounding);
  EXPECT_LT((contact.normal - kZ).norm(), kRounding);
}

TEST(VolumeContact, IsAsExactFarFromTheOriginAsNearIt) {
  const Vector3 away(0x1p20, -0x1p21, 0x1p19);  // metres; every coordinate below stays exact
  const auto expect_same = [&](const Volume& a, const Volume& b) {
    const TouchPoint near = touch(a, b, kZ);
    const TouchPoint far = touch(moved(a, away), moved(b, away), kZ);
    EXPECT_EQ(far.normal, near.normal);
    EXPECT_EQ(far.depth_m, near.depth_m);
    EXPECT_LT((far.point - away - near.point).norm(), 1e-9);
  };
  const Box below{{0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}, kUpright};
  expect_same(Box{{1.5, 1.0, 1.75}, {1.0, 1.0, 1.0}, kUpright}, below);
  expect_same(LineSwept{{0.0, 0.0, 0.0}, {2.0, 0.0, 0.0}, 0.3},
              LineSwept{{3.0, 0.375, 0.0}, {-2.0, 0.0, 0.0}, 0.1});
  expect_same(RectangleSwept{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, 0.5},
              RectangleSwept{{2.0, 0.0, 0.75}, {1.0, 1.0, 0.0}, {1.0, -1.0, 0.0}, 0.5});
}

TEST(VolumeContact, ABallOnABoxTouchesOnItsFace) {
  const Box box{{0.0, 0.0, 0.0}, {1.0, 2.0, 3.0}, kUpright};
  expect_contact(Sphere{{1.25, 0.5, 0.5}, 0.5}, box, kX, 0.25, {1.0, 0.5, 0.5});
  expect_contact(Sphere{{0.75, 0.5, 0.5}, 0.5}, box, kX, 0.75, {0.75, 0.5, 0.5});
}

TEST(VolumeContact, ANestedBoxIsPartedByTheNearestFace) {
  const Box outer{{0.0, 0.0, 0.0}, {4.0, 4.0, 4.0}, kUpright};
  const Box inner{{0.0, -3.0, 1.0}, {0.5, 0.5, 0.5}, kUpright};
  expect_contact(inner, outer, -kY, 1.5, {0.0, -3.0, 1.0});
}

TEST(VolumeContact, TwoCubesTouchAsTheSpheresThatCircumscribeThem) {
  const Cube cube{{0.0, 0.0, 0.0}, 1.0, kUpright};
  const Cube other{{1.5, 0.6, 0.0}, 0.5, kUpright};
  const Sphere round{cube.centre, std::sqrt(3.0)};
  const Sphere small{other.centre, 0.5 * std::sqrt(3.0)};
  expect_contact(other, cube, touch(small, round, kZ).normal, touch(small, round, kZ).depth_m,
                 touch(small, round, kZ).point);
  EXPECT_NEAR(interpenetration(other, cube, touch(other, cube, kZ)),
              interpenetration(small, round, touch(small, round, kZ)), 1e-15);
  EXPECT_FALSE(overlap(cube, Cube{{2.5, 0.0, 0.0}, 1.0, kUpright})) << "the spheres overlap";
}

TEST(VolumeContact, ACubeTouchesOtherKindsAsTheBoxThatItIs) {
  const Cube cube{{0.0, 0.0, 0.0}, 1.0, kUpright};
  const Box box{cube.centre, {1.0, 1.0, 1.0}, kUpright};
  // Near a corner of the face: a sphere about the cube would turn its normal by 40 degrees.
  const Sphere ball{{0.9, 1.25, 0.9}, 0.3};
  EXPECT_LT((touch(ball, cube, kZ).normal - kY).norm(), 1e-15);
  const LineSwept line{{0.5, 1.5, 0.0}, {1.0, 0.0, 0.0}, 0.75};
  const Box beside{{1.4, 0.2, 0.1}, {0.5, 0.2, 0.3}, Quaternion(0.9, 0.1, 0.2, 0.3).normalized()};
  for (const Volume& volume : {Volume(ball), Volume(line), Volume(beside)}) {
    EXPECT_EQ(touch(cube, volume, kZ).point, touch(box, volume, kZ).point);
    EXPECT_EQ(touch(cube, volume, kZ).normal, touch(box, volume, kZ).normal);
    EXPECT_EQ(touch(cube, volume, kZ).depth_m, touch(box, volume, kZ).depth_m);
  }
}

TEST(VolumeContact, CoincidentVolumesOfEveryKindFallBackOnTheGivenDirection) {
  RandomStream random(kSeed, "coincident");
  for (int kind = 0; kind < kKinds; ++kind) {
    for (int trial = 0; trial < 200; ++trial) {
      const Volume twin = random_volume(random, kind, random_in_cube(random, 1.0));
      const Vector3 fallback = random_direction(random);
      const TouchPoint contact = touch(twin, twin, fallback);
      ASSERT_TRUE(overlap(twin, twin)) << kKindNames[static_cast<std::size_t>(kind)];
      ASSERT_NEAR(contact.normal.norm(), 1.0, 1e-12);
      ASSERT_GT(contact.normal.dot(fallback), 0.0);
      ASSERT_LT((contact.point - bounding_sphere(twin).centre).norm(), kRounding);
      ASSERT_EQ(touch(twin, twin, -fallback).normal, -contact.normal);
    }
  }
}

TEST(VolumeContact, VolumesWithoutLengthAreTheLesserKind) {
  RandomStream random(kSeed, "degenerate");
  for (int trial = 0; trial < 500; ++trial) {
    const Vector3 centre = random_in_cube(random, 0.5);
    const double radius_m = uniform_in(random, 0.1, 0.5);
    const Vector3 half = random_turn(random) * Vector3(uniform_in(random, 0.1, 1.0), 0.0, 0.0);
    const Vector3 none = Vector3::Zero();
    const std::vector<std::pair<Volume, Volume>> alike{
        {LineSwept{centre, none, radius_m}, Sphere{centre, radius_m}},
        {RectangleSwept{centre, none, none, radius_m}, Sphere{centre, radius_m}},
        {RectangleSwept{centre, half, none, radius_m}, LineSwept{centre, half, radius_m}},
        {RectangleSwept{centre, none, half, radius_m}, LineSwept{centre, half, radius_m}},
    };
    const Volume other = random_volume(random, static_cast<int>(random.below(kKinds)),
                                       1.5 * random_direction(random));
    for (const auto& [lesser, kind] : alike) {
      ASSERT_EQ(overlap(lesser, other), overlap(kind, other)) << "seed " << kSeed;
      const TouchPoint x = touch(lesser, other, kX);
      const TouchPoint y = touch(kind, other, kX);
      ASSERT_NEAR(x.depth_m, y.depth_m, 1e-12) << "seed " << kSeed << ", trial " << trial;
      ASSERT_LT((x.normal - y.normal).norm(), 1e-6);
      ASSERT_LT((x.point - y.point).norm(), 1e-6);
    }
  }
}

TEST(VolumeContact, InterpenetrationOfSpheresIsTheCorrectedEquation) {
  RandomStream random(kSeed, "kappa");
  for (int trial = 0; trial < 500; ++trial) {
    const Sphere a{random_in_cube(random, 1.0), uniform_in(random, 0.1, 1.0)};
    const Sphere b{random_in_cube(random, 1.0), uniform_in(random, 0.1, 1.0)};
    const double d = (a.centre - b.centre).norm();
    const double kappa = std::clamp(
        (a.radius_m + b.radius_m - d) / (2.0 * std::min(a.radius_m, b.radius_m)), 0.0, 1.0);
    ASSERT_NEAR(interpenetration(a, b, touch(a, b, kX)), kappa, 1e-14);
  }
}

TEST(VolumeContact, SpheresAsVolumesGiveTheBitsOfSpheres) {
  RandomStream random(kSeed, "spheres");
  for (int trial = 0; trial < 2'000; ++trial) {
    const Sphere a{random_in_cube(random, 1.0), uniform_in(random, 0.0, 1.0)};
    const Sphere b{random_in_cube(random, 1.0), uniform_in(random, 0.0, 1.0)};
    const Pose pose{random_in_cube(random, 1.0), random_turn(random)};
    const TouchPoint plain = touch(a, b, kX);
    const TouchPoint general = touch(Volume(a), Volume(b), kX);
    ASSERT_EQ(overlap(Volume(a), Volume(b)), overlap(a, b));
    ASSERT_EQ(general.point, plain.point);
    ASSERT_EQ(general.normal, plain.normal);
    ASSERT_EQ(general.depth_m, plain.depth_m);
    ASSERT_EQ(std::get<Sphere>(placed(Volume(a), pose)).centre, pose.transform(a.centre));
    const ClosedCube walls{1.0};
    ASSERT_EQ(reaches_wall(walls, Volume(a)), reaches_wall(walls, a));
    for (int wall = 0; wall < kWallCount; ++wall) {
      ASSERT_EQ(touch_wall(walls, wall, Volume(a)).point, touch_wall(walls, wall, a).point);
      ASSERT_EQ(reach_beyond(walls, wall, Volume(a)), reach_beyond(walls, wall, a));
    }
  }
}

TEST(PlacedVolume, HoldsThePointsThatItHeldInItsFrame) {
  RandomStream random(kSeed, "placed");
  for (int trial = 0; trial < 2'000; ++trial) {
    const Volume volume = random_volume(random, trial % kKinds, random_in_cube(random, 0.5));
    const Pose pose{random_in_cube(random, 2.0), random_turn(random)};
    const Vector3 point = bounding_sphere(volume).centre + random_in_cube(random, 0.7);
    const Volume shrunk = std::visit(
        [](auto kind) {
          if constexpr (requires { kind.radius_m; }) {
            kind.radius_m -= 1e-9;
          }
          return Volume(kind);
        },
        volume);
    if (holds(shrunk, point) && volume.index() < 3) {
      ASSERT_TRUE(holds(placed(volume, pose), pose.transform(point)));
    }
    ASSERT_NEAR(content_m3(placed(volume, pose)), content_m3(volume), 1e-12);
  }
}

TEST(VolumeWalls, AVolumeReachesAsFarAsTheFurthestOfItsCorners) {
  RandomStream random(kSeed, "walls");
  const ClosedCube walls{1.0};
  int reached = 0;
  for (int trial = 0; trial < 3'000; ++trial) {
    const Volume volume = random_volume(random, trial % kKinds, random_in_cube(random, 1.0));
    const Corners corners = corners_of(volume);
    double furthest_m = -10.0;
    for (int wall = 0; wall < kWallCount; ++wall) {
      const Vector3 outward = -inward_normal(wall);
      double reach_m = -10.0;
      for (const Vector3& corner : corners.places) {
        reach_m = std::max(reach_m, corner.dot(outward) + corners.radius_m - 1.0);
      }
      ASSERT_NEAR(reach_beyond(walls, wall, volume), reach_m, 1e-13) << "seed " << kSeed;
      const TouchPoint contact = touch_wall(walls, wall, volume);
      ASSERT_EQ(contact.depth_m, reach_beyond(walls, wall, volume));
      ASSERT_EQ(contact.normal, inward_normal(wall));
      ASSERT_EQ(contact.point.dot(outward), 1.0);
      furthest_m = std::max(furthest_m, reach_m);
    }
    if (std::abs(furthest_m) > 1e-13) {
      ASSERT_EQ(reaches_wall(walls, volume), furthest_m > 0.0) << "seed " << kSeed;
    }
    reached += furthest_m > 0.0 ? 1 : 0;
  }
  EXPECT_GT(reached, 300);
  EXPECT_LT(reached, 2'700);
}

TEST(VolumeWalls, TheContactIsUnderTheMiddleOfWhatReachesFurthest) {
  const ClosedCube walls{1.0};
  const int floor = 3;  // at y = −1
  const double c = std::sqrt(0.5);
  const LineSwept leaning{{0.0, -0.5, 0.0}, {0.5, 0.25, 0.0}, 0.3};
  EXPECT_LT((touch_wall(walls, floor, leaning).point - Vector3(-0.5, -1.0, 0.0)).norm(), 1e-15);
  const LineSwept lying{{0.25, -0.5, 0.0}, {0.5, 0.0, 0.0}, 0.3};
  EXPECT_LT((touch_wall(walls, floor, lying).point - Vector3(0.25, -1.0, 0.0)).norm(), 1e-15);
  const Box on_edge{{0.5, 0.0, 0.0},
                    {0.5, 0.5, 0.25},
                    Quaternion(std::sqrt((1.0 + c) / 2.0), 0.0, 0.0, std::sqrt((1.0 - c) / 2.0))};
  EXPECT_LT((touch_wall(walls, floor, on_edge).point - Vector3(0.5, -1.0, 0.0)).norm(), 1e-15);
  const Cube on_corner{{0.25, -0.5, 0.0}, 0.5, Quaternion(0.9, 0.3, 0.3, 0.1).normalized()};
  EXPECT_EQ(touch_wall(walls, floor, on_corner).point, Vector3(0.25, -1.0, 0.0));
}

}  // namespace impetus::volume_contacts_test
