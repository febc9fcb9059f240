// SPDX-License-Identifier: MIT
#include <fcl/fcl.h>

#include "tests/bench/peers/peer_scene.hpp"

namespace impetus {

void empty_mesh_in_fcl() {
  using Model = fcl::BVHModel<fcl::OBBRSSd>;
  const auto mesh = std::make_shared<Model>();
  mesh->beginModel();
  mesh->endModel();
  const auto ball = std::make_shared<fcl::Sphered>(1.0);
  const fcl::CollisionObjectd first(mesh, fcl::Transform3d::Identity());
  const fcl::CollisionObjectd second(ball, fcl::Transform3d::Identity());
  const fcl::CollisionRequestd request;
  fcl::CollisionResultd result;
  fcl::collide(&first, &second, request, result);
}

}  // namespace impetus
