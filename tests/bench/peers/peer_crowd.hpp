// A crowd in an engine that is not ours: the same bodies, walls and steps.
//
// Every peer runs in its ordinary configuration, without friction, damping and sleep; what
// each is and what it was told stands at its factory.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include "engine/volumes/closed_cube.hpp"
#include "tests/bench/crowd_starts.hpp"

namespace impetus {

class PeerCrowd {
 public:
  virtual ~PeerCrowd() = default;
  virtual void step() = 0;  ///< by kCrowdStep_s
  [[nodiscard]] virtual std::vector<BodyState> states() const = 0;
};

/// Bullet, each body the convex hull of its mesh: sequential impulses, ten iterations, as it comes.
std::unique_ptr<PeerCrowd> bullet_of_hulls(const CrowdShape& shape, const BenchCrowdStart& start,
                                           double restitution);

/// Bullet, each body all its triangles (GImpact).
std::unique_ptr<PeerCrowd> bullet_of_triangles(const CrowdShape& shape,
                                               const BenchCrowdStart& start, double restitution);

/// ODE, each body all its triangles; quick step of twenty iterations, at most 16 contacts a pair.
std::unique_ptr<PeerCrowd> ode_of_triangles(const CrowdShape& shape, const BenchCrowdStart& start,
                                            double restitution);

/// The mesh in its principal axes, for engines whose inertia is diagonal.
struct PrincipalShape {
  TriangleMesh mesh;
  Quaternion to_shape;  ///< from the principal axes to the shape's own
  Vector3 moments;      ///< kg m²
};
PrincipalShape in_principal_axes(const CrowdShape& shape);

}  // namespace impetus
