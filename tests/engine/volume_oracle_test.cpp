// Spheres, capsules and boxes against FCL, the Flexible Collision Library (Pan et al. 2012).
// SPDX-License-Identifier: MIT
#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>
#include <gtest/gtest.h>

#include <memory>

#include "tests/engine/random_volumes.hpp"

namespace impetus::volume_oracle_test {

constexpr std::uint64_t kSeed = 43;
/// What FCL's iterations leave open for volumes of a metre.
constexpr double kIterations_m = 1e-6;

using Object = std::unique_ptr<fcl::CollisionObjectd>;

Object object(std::shared_ptr<fcl::CollisionGeometryd> shape, const Vector3& centre,
              const Quaternion& turn) {
  return std::make_unique<fcl::CollisionObjectd>(std::move(shape), turn.toRotationMatrix(), centre);
}

/// FCL's shape of a sphere, a capsule or a box. Its capsules lie along z.
Object shape_of(const Volume& volume) {
  if (const auto* sphere = std::get_if<Sphere>(&volume)) {
    return object(std::make_shared<fcl::Sphered>(sphere->radius_m), sphere->centre,
                  Quaternion::Identity());
  }
  if (const auto* line = std::get_if<LineSwept>(&volume)) {
    return object(std::make_shared<fcl::Capsuled>(line->radius_m, 2.0 * line->half_axis.norm()),
                  line->centre, Quaternion::FromTwoVectors(Vector3::UnitZ(), line->half_axis));
  }
  if (const auto* cube = std::get_if<Cube>(&volume)) {
    const double edge_m = 2.0 * cube->half_edge_m;
    return object(std::make_shared<fcl::Boxd>(edge_m, edge_m, edge_m), cube->centre,
                  cube->orientation);
  }
  const auto& box = std::get<Box>(volume);
  return object(std::make_shared<fcl::Boxd>(2.0 * box.half_extents_m), box.centre, box.orientation);
}

/// Of a kind FCL has, and thick.
Volume thick_volume(RandomStream& random, int kind, const Vector3& centre) {
  const Quaternion turn = random_turn(random);
  const auto length = [&] { return uniform_in(random, 0.05, 1.0); };
  switch (kind) {
    case 0:
      return Sphere{centre, length()};
    case 1:
      return LineSwept{centre, turn * Vector3(length(), 0.0, 0.0), 0.5 * length()};
    case 2:
      return Box{centre, {length(), length(), length()}, turn};
    default:
      return Cube{centre, length(), turn};
  }
}

bool fcl_overlap(const Volume& a, const Volume& b) {
  fcl::CollisionRequestd request;
  fcl::CollisionResultd result;
  fcl::collide(shape_of(a).get(), shape_of(b).get(), request, result);
  return result.isCollision();
}

double fcl_distance_m(const Volume& a, const Volume& b) {
  fcl::DistanceRequestd request(true);
  request.distance_tolerance = 1e-9;
  fcl::DistanceResultd result;
  return fcl::distance(shape_of(a).get(), shape_of(b).get(), request, result);
}

class Fcl : public ::testing::TestWithParam<std::pair<int, int>> {};

TEST_P(Fcl, AgreesOnWhatOverlapsAndOnHowFarApartTheOthersAre) {
  RandomStream random(kSeed, "fcl");
  const auto [kind_a, kind_b] = GetParam();
  int met = 0;
  int apart = 0;
  for (int trial = 0; trial < 1'000; ++trial) {
    const Volume a = thick_volume(random, kind_a, random_in_cube(random, 1.0));
    const Volume b = thick_volume(random, kind_b, random_in_cube(random, 1.5));
    const TouchPoint contact = touch(a, b, Vector3::UnitX());
    const bool is_cube = kind_a == 3 || kind_b == 3;
    if (!is_cube && std::abs(contact.depth_m) < kIterations_m) {
      continue;
    }
    if (overlap(a, b)) {
      ++met;
      // A cube's depth is that of its sphere, so only a clear gap contradicts.
      ASSERT_TRUE(fcl_overlap(a, b) || (is_cube && fcl_distance_m(a, b) < kIterations_m))
          << "seed " << kSeed << ", trial " << trial << ", depth " << contact.depth_m;
    } else {
      ++apart;
      ASSERT_FALSE(fcl_overlap(a, b)) << "seed " << kSeed << ", trial " << trial;
      if (!is_cube) {
        ASSERT_NEAR(fcl_distance_m(a, b), -contact.depth_m, kIterations_m) << "trial " << trial;
      }
    }
  }
  EXPECT_GT(met, 100);
  EXPECT_GT(apart, 100);
}

constexpr std::array<const char*, 4> kNames{"Sphere", "Capsule", "Box", "Cube"};

std::string name_of_pair(const ::testing::TestParamInfo<std::pair<int, int>>& each) {
  const auto [a, b] = each.param;
  return std::string(kNames[static_cast<std::size_t>(a)]) + kNames[static_cast<std::size_t>(b)];
}

INSTANTIATE_TEST_SUITE_P(OfKinds, Fcl,
                         ::testing::Values(std::pair(0, 0), std::pair(0, 1), std::pair(0, 2),
                                           std::pair(0, 3), std::pair(1, 1), std::pair(1, 2),
                                           std::pair(1, 3), std::pair(2, 2), std::pair(2, 3),
                                           std::pair(3, 3)),
                         name_of_pair);

}  // namespace impetus::volume_oracle_test
