// Two bodies in a library that is not ours: how many contacts it finds at a pose.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "engine/shapes/triangle_mesh.hpp"

namespace impetus {

class PeerPair {
 public:
  virtual ~PeerPair() = default;
  /// The first body has the identity.
  virtual int contacts_at(const Pose& b) = 0;
};

/// FCL, all contacts of the triangles: oriented boxes with swept spheres.
std::unique_ptr<PeerPair> fcl_triangle_pair(const TriangleMesh& mesh);
/// ODE, the contacts of the triangles, at most 1,000.
std::unique_ptr<PeerPair> ode_triangle_pair(const TriangleMesh& mesh);
/// Bullet: GImpact, and the convex hull.
std::unique_ptr<PeerPair> bullet_triangle_pair(const TriangleMesh& mesh);
std::unique_ptr<PeerPair> bullet_hull_pair(const TriangleMesh& mesh);

}  // namespace impetus
