// The hidden share of a gap, beside every ray against every face.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <memory>

#include "engine/numerics/random_stream.hpp"
#include "engine/shapes/mesh_distance.hpp"
#include "experiments/protocol/screen_file.hpp"
#include "experiments/run/collision_truth.hpp"

namespace impetus::hidden_share_test {

Vector3 drawn_vector(RandomStream& random, double reach) {
  const double x = reach * (2.0 * random.uniform() - 1.0);
  const double y = reach * (2.0 * random.uniform() - 1.0);
  return {x, y, reach * (2.0 * random.uniform() - 1.0)};
}

/// Triangles anywhere within 2 cm: no solid, but faces in every direction.
DrawnBody drawn_body(RandomStream& random, std::size_t faces) {
  auto mesh = std::make_shared<TriangleMesh>();
  for (std::uint32_t face = 0; face < faces; ++face) {
    const Vector3 centre = drawn_vector(random, 0.02);
    for (int corner = 0; corner < 3; ++corner) {
      mesh->vertices.push_back(centre + drawn_vector(random, 0.01));
    }
    mesh->triangles.push_back({3 * face, 3 * face + 1, 3 * face + 2});
  }
  DrawnBody body;
  body.mesh = mesh;
  return body;
}

/// Möller and Trumbore 1997, on every face.
bool covered(const DrawnBody& body, const Pose& pose, const Vector3& eye, const Vector3& target) {
  for (const auto& [i, j, k] : body.mesh->triangles) {
    const Vector3 a = pose.transform(body.mesh->vertices[i]);
    const Vector3 ab = pose.transform(body.mesh->vertices[j]) - a;
    const Vector3 ac = pose.transform(body.mesh->vertices[k]) - a;
    const Vector3 ray = target - eye;
    const double determinant = ab.dot(ray.cross(ac));
    const double u = (eye - a).dot(ray.cross(ac)) / determinant;
    const double v = ray.dot((eye - a).cross(ab)) / determinant;
    const double t = ac.dot((eye - a).cross(ab)) / determinant;
    if (u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t > 0.0 && t < 1.0 - 1e-6) {
      return true;
    }
  }
  return false;
}

TEST(HiddenShare, ItIsThatOfEveryRayAgainstEveryFace) {
  constexpr std::uint64_t kSeed = 31;
  constexpr int kRays = 64;
  RandomStream random(kSeed, "gaps");
  const Viewer viewer = viewer_at(assumed_screen(), 0.0);
  int partly = 0;
  for (int round = 0; round < 60; ++round) {
    const DrawnBody a = drawn_body(random, 40);
    const DrawnBody b = drawn_body(random, 40);
    const Pose at_a{drawn_vector(random, 0.02), Quaternion::Identity()};
    const Pose at_b{Vector3(0.07, 0.0, 0.0) + drawn_vector(random, 0.02), Quaternion::Identity()};
    const ClosestPoints gap = mesh_distance(*a.mesh, at_a, *b.mesh, at_b);
    int hidden = 0;
    for (int ray = 0; ray < kRays; ++ray) {
      const Vector3 target = gap.on_a + (ray + 0.5) / kRays * (gap.on_b - gap.on_a);
      hidden += covered(a, at_a, viewer.eye, target) || covered(b, at_b, viewer.eye, target);
    }
    const double share = gap.distance_m > 0.0 ? static_cast<double>(hidden) / kRays : 0.0;
    EXPECT_EQ(measure_truth(a, at_a, b, at_b, viewer).hidden_share, share)
        << "seed " << kSeed << ", round " << round;
    partly += share > 0.0 && share < 1.0 ? 1 : 0;
  }
  EXPECT_GT(partly, 5) << "most gaps were hidden whole or not at all";
}

}  // namespace impetus::hidden_share_test
