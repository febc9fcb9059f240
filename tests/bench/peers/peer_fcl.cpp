// SPDX-License-Identifier: MIT
#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/narrowphase/collision.h>

#include "tests/bench/peers/peer_pair.hpp"

namespace impetus {
namespace {

class FclPair final : public PeerPair {
 public:
  explicit FclPair(const TriangleMesh& mesh)
      : model_(std::make_shared<fcl::BVHModel<fcl::OBBRSSd>>()) {
    std::vector<fcl::Triangle> triangles;
    for (const auto& [a, b, c] : mesh.triangles) {
      triangles.emplace_back(a, b, c);
    }
    model_->beginModel();
    model_->addSubModel(mesh.vertices, triangles);
    model_->endModel();
  }

  int contacts_at(const Pose& b) override {
    fcl::Transform3d X_AB = fcl::Transform3d::Identity();
    X_AB.linear() = b.orientation.toRotationMatrix();
    X_AB.translation() = b.position;
    const fcl::CollisionRequestd request(/*num_max_contacts=*/1'000'000, /*enable_contact=*/true);
    fcl::CollisionResultd result;
    fcl::collide(model_.get(), fcl::Transform3d::Identity(), model_.get(), X_AB, request, result);
    return static_cast<int>(result.numContacts());
  }

 private:
  std::shared_ptr<fcl::BVHModel<fcl::OBBRSSd>> model_;
};

}  // namespace

std::unique_ptr<PeerPair> fcl_triangle_pair(const TriangleMesh& mesh) {
  return std::make_unique<FclPair>(mesh);
}

}  // namespace impetus
