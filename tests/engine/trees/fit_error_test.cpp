// How far volumes reach beyond a solid: closed forms, and never less than samples say.
// SPDX-License-Identifier: MIT
#include "engine/trees/fit_error.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "engine/shapes/solids/block_meshes.hpp"
#include "engine/shapes/solids/creature_mesh.hpp"
#include "engine/shapes/solids/ring_meshes.hpp"
#include "engine/shapes/triangle_distance.hpp"
#include "engine/trees/surface_part.hpp"
#include "engine/volumes/rounded_box.hpp"
#include "tests/engine/one_of_each_kind.hpp"

namespace impetus::fit_error_test {

constexpr std::uint64_t kSeed = 71;

/// The greatest distance found at random points of the volume, most of them on its surface.
double sampled_m(const Volume& volume, const SurfaceDistance& solid, RandomStream& random,
                 int samples) {
  const RoundedBox form = rounded_box(volume);
  double worst_m = 0.0;
  for (int i = 0; i < samples; ++i) {
    Vector3 core = random_in_cube(random, 1.0);
    const Vector3 rounded = random_direction(random);
    const double scale = 1.0 / core.cwiseAbs().maxCoeff();
    core *= i % 4 == 0 ? 1.0 : scale;
    const Vector3 local = core.cwiseProduct(form.half_extents_m) + form.radius_m * rounded;
    worst_m = std::max(worst_m, solid.signed_distance_m(form.placed(local)));
  }
  return worst_m;
}

struct KnownFit {
  std::string name;
  Volume volume;
  double expected_m;
};

TEST(FitError, EqualsClosedFormsAboutACube) {
  const SurfaceDistance cube(box_mesh({1.0, 1.0, 1.0}));
  const Quaternion straight = Quaternion::Identity();
  const std::vector<KnownFit> known{
      {"a sphere round it", Sphere{Vector3::Zero(), std::sqrt(0.75)}, std::sqrt(0.75) - 0.5},
      {"a sphere on a face", Sphere{{0.5, 0.0, 0.0}, 0.1}, 0.1},
      {"a sphere apart", Sphere{{2.0, 0.0, 0.0}, 0.25}, 1.75},
      {"a box round it", Box{Vector3::Zero(), {0.6, 0.6, 0.6}, straight}, 0.1 * std::sqrt(3.0)},
      {"a box out of one face", Box{{0.3, 0.0, 0.0}, {0.3, 0.2, 0.2}, straight}, 0.1},
      {"a cube apart", Cube{{0.0, 0.0, 2.0}, 0.5, straight}, 2.0},
      {"a line out of a face", LineSwept{{0.4, 0.0, 0.0}, {0.0, 0.2, 0.0}, 0.15}, 0.05},
      {"a line through two", LineSwept{Vector3::Zero(), {0.6, 0.0, 0.0}, 0.1}, 0.2},
      {"a rectangle through four",
       RectangleSwept{Vector3::Zero(), {0.6, 0.0, 0.0}, {0.0, 0.7, 0.0}, 0.05},
       0.05 + std::hypot(0.1, 0.2)}};
  for (const auto& [name, volume, expected_m] : known) {
    const double found_m = fit_error_m(volume, cube);
    const double size_m = bounding_sphere(volume).radius_m;
    EXPECT_GE(found_m, expected_m * (1.0 - 1e-12)) << name;
    EXPECT_LE(found_m, expected_m * (1.0 + kFitTolerance) + kFitResolution * size_m) << name;
  }
}

TEST(FitError, IsNothingForVolumesWithin) {
  const SurfaceDistance cube(box_mesh({1.0, 1.0, 1.0}));
  EXPECT_EQ(fit_error_m(Sphere{{0.1, 0.0, 0.2}, 0.29}, cube), 0.0);
  EXPECT_EQ(fit_error_m(Cube{{0.2, 0.0, 0.0}, 0.1}, cube), 0.0);
  const Box itself{Vector3::Zero(), {0.5, 0.5, 0.5}};
  EXPECT_LE(fit_error_m(itself, cube), 1e-8) << "but for the skin";
  EXPECT_LE(fit_error_m(Box{{0.25, 0.0, 0.0}, {0.25, 0.5, 0.5}}, cube), 1e-8);
}

TEST(FitError, SeesAHollowInTheMiddleOfAVolume) {
  // The farthest point from a torus is in its hole, deep within a flat box, not on the surface.
  const SurfaceDistance torus(torus_mesh(1.0, 0.2, 96, 48));
  const Sphere ball{Vector3::Zero(), 0.85};
  EXPECT_NEAR(fit_error_m(ball, torus), std::hypot(1.0, 0.85) - 0.2, 0.03);
  const Sphere small{Vector3(0.9, 0.0, 0.0), 0.95};  // reaches past the hole's centre
  const double bound_m = fit_error_m(small, torus);
  EXPECT_GE(bound_m, 0.8 - 0.005) << "the centre of the hole";
}

TEST(FitError, BoundsWhatSamplesFindAndIsTightForEveryKind) {
  RandomStream random(kSeed, "kinds");
  const SurfaceDistance creature(creature_mesh(2.0, 16));
  int reaching = 0;
  int tight = 0;
  for (int trial = 0; trial < 25; ++trial) {
    for (const Volume& volume :
         one_of_each_kind(random, random_in_cube(random, 0.6), uniform_in(random, 0.1, 0.6))) {
      const double found_m = sampled_m(volume, creature, random, 1'500);
      const double bound_m = fit_error_m(volume, creature);
      ASSERT_GE(bound_m, found_m) << "seed " << kSeed << ", trial " << trial << ", kind "
                                  << volume.index();
      reaching += found_m > 0.0 ? 1 : 0;
      // The samples' own shortfall is a few percent, mostly at corners of boxes.
      tight += found_m > 0.0 && bound_m < 1.1 * found_m + 0.01 * bounding_sphere(volume).radius_m;
    }
  }
  EXPECT_GT(reaching, 100);
  EXPECT_GT(tight, reaching * 9 / 10);
}

TEST(FitError, IsTightForRoundNodesThatLieMostlyWithinTheSolid) {
  // Such a node's bound comes from points beside it: only its own may count as found.
  RandomStream random(kSeed, "mostly within");
  const TriangleMesh mesh = torus_mesh(0.5, 0.2, 36, 14);
  const SurfaceDistance solid(mesh);
  int tight = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const double x = uniform_in(random, -0.04, 0.04);
    const double radius_m = uniform_in(random, 0.15, 0.21);
    const Volume node = LineSwept{Vector3(x, 0.5, 0.0), Vector3(0.05, 0.0, 0.0), radius_m};
    const Volume turned = LineSwept{Vector3(0.5, x, 0.0), Vector3(0.0, 0.05, 0.0), radius_m};
    for (const Volume& volume : {node, turned}) {
      const double bound_m = fit_error_m(volume, solid);
      const double found_m = sampled_m(volume, solid, random, 3'000);
      ASSERT_GE(bound_m, found_m);
      tight += bound_m <= 1.02 * found_m + 0.1 * radius_m ? 1 : 0;
    }
  }
  EXPECT_GE(tight, 75) << "of 120; the others run out of work";
}

TEST(FitError, StillBoundsWhenTheWorkRunsOut) {
  RandomStream random(kSeed, "short of work");
  const SurfaceDistance creature(creature_mesh(2.0, 16));
  for (int trial = 0; trial < 10; ++trial) {
    for (const Volume& volume : one_of_each_kind(random, random_in_cube(random, 0.6), 0.4)) {
      const double found_m = sampled_m(volume, creature, random, 300);
      double before_m = std::numeric_limits<double>::infinity();
      for (const int questions : {1, 10, 100}) {
        const double bound_m = fit_error_m(volume, creature, 0.0, questions);
        ASSERT_GE(bound_m, found_m) << "seed " << kSeed << ", trial " << trial;
        ASSERT_LE(bound_m, before_m * (1.0 + 1e-12)) << "more work, no worse";
        before_m = bound_m;
      }
    }
  }
}

TEST(FitError, BelowWhatIsIndifferentItStopsEarlyAndAboveItIsTheSame) {
  RandomStream random(kSeed, "indifferent");
  const SurfaceDistance creature(creature_mesh(2.0, 16));
  for (int trial = 0; trial < 10; ++trial) {
    for (const Volume& volume : one_of_each_kind(random, random_in_cube(random, 0.6), 0.4)) {
      const double bound_m = fit_error_m(volume, creature);
      EXPECT_LE(fit_error_m(volume, creature, 2.0 * bound_m), 2.0 * bound_m * (1.0 + 1e-12));
      EXPECT_GE(fit_error_m(volume, creature, 0.5 * bound_m), 0.95 * bound_m);
    }
  }
}

TEST(TriangleInBox, AgreesWithCuttingTheTriangleByTheFaces) {
  RandomStream random(kSeed, "boxes");
  const Vector3 half(0.5, 0.3, 0.2);
  int met = 0;
  for (int trial = 0; trial < 5'000; ++trial) {
    const Triangle triangle{random_in_cube(random, 1.0), random_in_cube(random, 1.0),
                            random_in_cube(random, 1.0)};
    SurfacePart part{{{triangle[0], triangle[1], triangle[2]}, Vector3::Zero(), 0}};
    for (int axis = 0; axis < 3; ++axis) {
      part = cut(part, {Vector3::Unit(axis), -half[axis]}).first;
      part = cut(part, {-Vector3::Unit(axis), -half[axis]}).first;
    }
    ASSERT_EQ(meets_box(triangle, half), !part.empty()) << "seed " << kSeed << ", trial " << trial;
    met += part.empty() ? 0 : 1;
  }
  EXPECT_GT(met, 500);
  EXPECT_LT(met, 4'500);
}

TEST(SurfaceDistance, TrianglesNearAPointAreAllThatComeWithin) {
  RandomStream random(kSeed, "near");
  const TriangleMesh mesh = creature_mesh(2.0, 16);
  const SurfaceDistance distance(mesh);
  for (int trial = 0; trial < 50; ++trial) {
    const Vector3 point = random_in_cube(random, 1.0);
    const double radius_m = uniform_in(random, 0.05, 0.5);
    const std::vector<Triangle> near = distance.triangles_near(point, radius_m);
    for (std::uint32_t index = 0; index < mesh.triangles.size(); ++index) {
      const Triangle triangle = distance.corners(index);
      if ((closest_on_triangle(triangle, point) - point).norm() <= radius_m) {
        ASSERT_NE(std::find(near.begin(), near.end(), triangle), near.end());
      }
    }
    EXPECT_LT(near.size(), mesh.triangles.size());
  }
}

}  // namespace impetus::fit_error_test
