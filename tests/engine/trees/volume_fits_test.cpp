// What fits are made of, each against brute force.
// SPDX-License-Identifier: MIT
#include "engine/trees/builders/volume_fits.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "engine/numerics/elementary_functions.hpp"
#include "engine/shapes/solids/ring_meshes.hpp"
#include "engine/trees/builders/reach_beyond.hpp"
#include "engine/trees/minimal_ball.hpp"
#include "tests/engine/builders.hpp"

namespace impetus::volume_fits_test {

constexpr std::uint64_t kSeed = 88;

std::vector<Vector3> random_points(RandomStream& random, int count, const Vector3& scale) {
  std::vector<Vector3> points;
  for (int i = 0; i < count; ++i) {
    points.emplace_back(random_in_cube(random, 1.0).cwiseProduct(scale));
  }
  return points;
}

double radius_about(const Vector3& centre, const std::vector<Vector3>& points) {
  double radius_m = 0.0;
  for (const Vector3& point : points) {
    radius_m = std::max(radius_m, (point - centre).norm());
  }
  return radius_m;
}

TEST(MinimalBall, NoOtherCentreIsBetter) {
  // The radius about a centre is convex, so a centre that nothing near it betters is the best.
  RandomStream random(kSeed, "minimal ball");
  for (int trial = 0; trial < 200; ++trial) {
    const Vector3 scale = trial % 3 == 0 ? Vector3(1.0, 1.0, 0.0) : Vector3(1.0, 0.3, 1e-3);
    const std::vector<Vector3> points =
        random_points(random, 1 + static_cast<int>(random.below(40)), scale);
    const Sphere ball = minimal_ball(points);
    EXPECT_EQ(ball.radius_m, radius_about(ball.centre, points));
    for (int other = 0; other < 50; ++other) {
      const Vector3 centre =
          ball.centre + 0.01 * ball.radius_m * random.uniform() * random_direction(random);
      ASSERT_GE(radius_about(centre, points), ball.radius_m * (1.0 - 1e-9))
          << "seed " << kSeed << ", trial " << trial;
    }
  }
}

TEST(MinimalBall, OfRegularPointsIsTheirOwn) {
  EXPECT_EQ(minimal_ball({Vector3(1.0, 2.0, 3.0)}).radius_m, 0.0);
  std::vector<Vector3> cube;
  for (int i = 0; i < 8; ++i) {
    cube.emplace_back(i & 1, i >> 1 & 1, i >> 2 & 1);
  }
  cube.insert(cube.end(), cube.begin(), cube.end());
  const Sphere ball = minimal_ball(cube);
  EXPECT_NEAR(ball.radius_m, std::sqrt(0.75), 1e-14);
  EXPECT_LT((ball.centre - Vector3::Constant(0.5)).norm(), 1e-14);
}

TEST(LeastRectangle, NoTurnInItsPlaneIsSmaller) {
  RandomStream random(kSeed, "rectangle");
  const auto area = [](const std::vector<Vector3>& points, const Matrix3& frame) {
    Vector3 least = Vector3::Constant(1e9);
    Vector3 most = -least;
    for (const Vector3& point : points) {
      least = least.cwiseMin(frame.transpose() * point);
      most = most.cwiseMax(frame.transpose() * point);
    }
    return (most - least).head<2>().prod();
  };
  for (int trial = 0; trial < 100; ++trial) {
    const std::vector<Vector3> points = random_points(random, 30, Vector3(1.0, 0.5, 0.7));
    const Vector3 normal = random_direction(random);
    const Matrix3 frame = least_rectangle_frame(points, normal);
    EXPECT_LT((frame.transpose() * frame - Matrix3::Identity()).norm(), 1e-12);
    EXPECT_GT(frame.determinant(), 0.0);
    EXPECT_EQ(frame.col(2), normal);
    for (int degree = 0; degree < 90; ++degree) {
      const auto [sine, cosine] = sine_cosine_deg(degree);
      Matrix3 turned = frame;
      turned.col(0) = cosine * frame.col(0) + sine * frame.col(1);
      turned.col(1) = cosine * frame.col(1) - sine * frame.col(0);
      ASSERT_GE(area(points, turned), area(points, frame) * (1.0 - 1e-12)) << "seed " << kSeed;
    }
  }
}

TEST(Eigenvectors, DiagonaliseAndComeInOrder) {
  RandomStream random(kSeed, "eigenvectors");
  for (int trial = 0; trial < 200; ++trial) {
    Matrix3 any;
    any << random_in_cube(random, 1.0), random_in_cube(random, 1.0), random_in_cube(random, 1.0);
    const Matrix3 symmetric = any * any.transpose();
    const Matrix3 vectors = eigenvectors_of(symmetric);
    const Matrix3 diagonal = vectors.transpose() * symmetric * vectors;
    EXPECT_LT((vectors.transpose() * vectors - Matrix3::Identity()).norm(), 1e-12);
    EXPECT_NEAR(vectors.determinant(), 1.0, 1e-12);
    EXPECT_LT((diagonal - Matrix3(diagonal.diagonal().asDiagonal())).norm(), 1e-12);
    EXPECT_GE(diagonal(0, 0), diagonal(1, 1));
    EXPECT_GE(diagonal(1, 1), diagonal(2, 2));
  }
}

TEST(CompassSearch, FindsTheBottomOfABowlAndNeverAWorsePlace) {
  const auto bowl = [](const std::array<double, 2>& at, double) {
    return (at[0] - 0.3) * (at[0] - 0.3) + 4.0 * (at[1] + 0.7) * (at[1] + 0.7);
  };
  const std::array<double, 2> best = compass_search<2>({0.5, 0.5}, 60, bowl);
  EXPECT_NEAR(best[0], 0.3, 1e-6);
  EXPECT_NEAR(best[1], -0.7, 1e-6);
  const auto lone = [](const std::array<double, 2>& at, double) {
    return at[0] == 0.0 && at[1] == 0.0 ? 0.0 : 1.0;
  };
  EXPECT_EQ((compass_search<2>({0.5, 0.5}, 10, lone)), (std::array<double, 2>{}));
}

/// Points of the torus' upper half.
SurfacePart half_torus(const TriangleMesh& mesh) {
  return cut(whole_surface(mesh), {Vector3(0.2, 1.0, 0.1).normalized(), 0.05}).first;
}

TEST(VolumeFits, EveryKindHoldsAllThePointsOnceItIsGrown) {
  const TriangleMesh mesh = torus_mesh(1.0, 0.3, 24, 12);
  const SurfacePart part = half_torus(mesh);
  const PartShape shape = shape_of(part);
  const SurfaceDistance exact(mesh);
  const RoughDistance rough(exact, {Vector3(-1.3, -1.3, -0.3), Vector3(1.3, 1.3, 0.3)}, 60);
  const std::vector<Matrix3> frames =
      frames_worth_trying(shape, Matrix3::Identity(), Effort::kCareful);
  const FitTask task{&shape, DistanceToUse(rough), frames, Effort::kCareful};
  for (const auto fit : {fit_sphere, fit_line, fit_rectangle, fit_box}) {
    const Fit made = fit(task);
    const std::vector<Vector3> corners = corners_of(part);
    const Volume grown = grown_to_hold(made.volume, corners, 1e-12);
    for (const Vector3& corner : corners) {
      ASSERT_TRUE(holds(grown, corner)) << "kind " << made.volume.index();
    }
    EXPECT_LT(bounding_sphere(grown).radius_m, 1.2 * bounding_sphere(made.volume).radius_m);
    EXPECT_GT(made.reach_m, 0.0);
  }
}

TEST(VolumeFits, RefittingShrinksWhatIsTooWide) {
  const std::vector<Vector3> corners{Vector3(1.0, 0.0, 0.0), Vector3(-1.0, 0.0, 0.0)};
  const Volume wide[] = {
      Sphere{Vector3::Zero(), 9.0}, LineSwept{Vector3::Zero(), Vector3(0.5, 0.0, 0.0), 9.0},
      RectangleSwept{Vector3::Zero(), Vector3(0.5, 0.0, 0.0), Vector3(0.0, 0.5, 0.0), 9.0},
      Box{Vector3(2.0, 0.0, 0.0), Vector3(9.0, 9.0, 9.0)}};
  for (const Volume& volume : wide) {
    EXPECT_LE(bounding_sphere(grown_to_hold(volume, corners, 1e-12)).radius_m, 1.3);
  }
}

TEST(ReachBeyond, OfABoxIsTheFarthestOfManySamples) {
  RandomStream random(kSeed, "reach");
  const TriangleMesh mesh = torus_mesh(1.0, 0.3, 24, 12);
  const SurfaceDistance exact(mesh);
  const RoughDistance rough(exact, {Vector3(-1.3, -1.3, -0.3), Vector3(1.3, 1.3, 0.3)}, 60);
  for (int trial = 0; trial < 30; ++trial) {
    const Box box{random_in_cube(random, 1.0),
                  Vector3(0.05, 0.05, 0.05) + random_in_cube(random, 0.25).cwiseAbs(),
                  random_turn(random)};
    double sampled_m = 0.0;
    for (int sample = 0; sample < 3'000; ++sample) {
      Vector3 local = random_in_cube(random, 1.0);
      local[sample % 3] = sample / 3 % 2 == 0 ? 1.0 : -1.0;
      const Vector3 point = box.centre + box.orientation * local.cwiseProduct(box.half_extents_m);
      sampled_m = std::max(sampled_m, exact.signed_distance_m(point));
    }
    const double reach_m = reach_beyond_m(box, DistanceToUse(rough), {2'000});
    const double size_m = box.half_extents_m.norm();
    EXPECT_LE(sampled_m, reach_m * 1.03 + 3e-3 * size_m) << "seed " << kSeed << " " << trial;
    EXPECT_GE(sampled_m, 0.9 * reach_m - 0.05 * size_m) << "seed " << kSeed << " " << trial;
  }
}

TEST(RoughDistance, LiesWithinACellOfTheTruth) {
  RandomStream random(kSeed, "rough");
  const TriangleMesh mesh = torus_mesh(1.0, 0.3, 24, 12);
  const SurfaceDistance exact(mesh);
  const RoughDistance rough(exact, {Vector3(-1.3, -1.3, -0.3), Vector3(1.3, 1.3, 0.3)}, 60);
  for (int trial = 0; trial < 5'000; ++trial) {
    const Vector3 point = random_in_cube(random, 1.6);
    ASSERT_NEAR(rough.interpolated_m(point), exact.signed_distance_m(point), rough.spacing_m());
  }
}

}  // namespace impetus::volume_fits_test
