// SPDX-License-Identifier: MIT
#include <btBulletDynamicsCommon.h>

#include <BulletCollision/Gimpact/btGImpactCollisionAlgorithm.h>
#include <BulletCollision/Gimpact/btGImpactShape.h>

#include <cmath>

#include "tests/bench/peers/peer_crowd.hpp"
#include "tests/bench/peers/peer_pair.hpp"

namespace impetus {
namespace {

btVector3 to_bullet(const Vector3& v) {
  return {static_cast<btScalar>(v.x()), static_cast<btScalar>(v.y()), static_cast<btScalar>(v.z())};
}

btTransform to_bullet(const Pose& pose) {
  const Quaternion& q = pose.orientation;
  const btQuaternion turn(static_cast<btScalar>(q.x()), static_cast<btScalar>(q.y()),
                          static_cast<btScalar>(q.z()), static_cast<btScalar>(q.w()));
  return btTransform(turn, to_bullet(pose.position));
}

Vector3 from_bullet(const btVector3& v) { return {v.x(), v.y(), v.z()}; }

/// The triangles, which GImpact's shape refers to.
struct BulletTriangles {
  explicit BulletTriangles(const TriangleMesh& mesh) {
    for (const auto& [a, b, c] : mesh.triangles) {
      triangles.addTriangle(to_bullet(mesh.vertices[a]), to_bullet(mesh.vertices[b]),
                            to_bullet(mesh.vertices[c]));
    }
  }
  btTriangleMesh triangles;
};

std::unique_ptr<btCollisionShape> hull_of(const TriangleMesh& mesh) {
  auto hull = std::make_unique<btConvexHullShape>();
  for (const Vector3& vertex : mesh.vertices) {
    hull->addPoint(to_bullet(vertex), false);
  }
  hull->recalcLocalAabb();
  hull->optimizeConvexHull();
  return hull;
}

std::unique_ptr<btGImpactMeshShape> gimpact_of(BulletTriangles& triangles) {
  auto shape = std::make_unique<btGImpactMeshShape>(&triangles.triangles);
  shape->setMargin(0.0F);
  shape->updateBound();
  return shape;
}

/// A world with Bullet's defaults, and GImpact known to it.
struct BulletWorld {
  BulletWorld() { btGImpactCollisionAlgorithm::registerAlgorithm(&dispatcher); }
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher{&configuration};
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btDiscreteDynamicsWorld world{&dispatcher, &broadphase, &solver, &configuration};
};

class BulletCrowd final : public PeerCrowd {
 public:
  BulletCrowd(const CrowdShape& shape, const BenchCrowdStart& start, double restitution, bool hulls)
      : model_(model_of(shape, shape.coarse)),
        principal_(in_principal_axes(shape)),
        triangles_(principal_.mesh),
        restitution_(static_cast<btScalar>(std::sqrt(restitution))) {
    shape_ = hulls ? hull_of(principal_.mesh) : gimpact_of(triangles_);
    bullet_.world.setGravity(to_bullet(start.gravity_m_s2));
    for (const BodyState& state : start.states) {
      add_body(state, shape.mass.mass_kg);
    }
    if (start.half_edge_m > 0.0) {
      add_walls(start.half_edge_m);
    }
  }
  ~BulletCrowd() override {
    for (const auto& body : bodies_) {
      bullet_.world.removeRigidBody(body.get());
    }
  }
  BulletCrowd(const BulletCrowd&) = delete;
  BulletCrowd& operator=(const BulletCrowd&) = delete;

  void step() override {
    bullet_.world.stepSimulation(static_cast<btScalar>(kCrowdStep_s), /*maxSubSteps=*/0);
  }

  [[nodiscard]] std::vector<BodyState> states() const override {
    std::vector<BodyState> states;
    for (std::size_t i = 0; i < count_; ++i) {
      const btRigidBody& body = *bodies_[i];
      const btQuaternion q = body.getWorldTransform().getRotation();
      BodyState state;
      state.pose.position = from_bullet(body.getWorldTransform().getOrigin());
      state.pose.orientation =
          Quaternion(q.w(), q.x(), q.y(), q.z()) * principal_.to_shape.conjugate();
      state.linear_momentum = from_bullet(body.getLinearVelocity()) / model_.inverse_mass;
      state.angular_momentum = angular_momentum_at(model_, state.pose.orientation,
                                                   from_bullet(body.getAngularVelocity()));
      states.push_back(state);
    }
    return states;
  }

 private:
  void add_body(const BodyState& state, double mass_kg) {
    btRigidBody::btRigidBodyConstructionInfo info(static_cast<btScalar>(mass_kg), nullptr,
                                                  shape_.get(), to_bullet(principal_.moments));
    info.m_startWorldTransform =
        to_bullet(Pose{state.pose.position, state.pose.orientation * principal_.to_shape});
    info.m_restitution = restitution_;
    info.m_friction = 0.0F;
    bodies_.push_back(std::make_unique<btRigidBody>(info));
    btRigidBody& body = *bodies_.back();
    body.setLinearVelocity(to_bullet(velocity(model_, state)));
    body.setAngularVelocity(to_bullet(angular_velocity(model_, state)));
    body.setActivationState(DISABLE_DEACTIVATION);
    bullet_.world.addRigidBody(&body);
    ++count_;
  }

  void add_walls(double half_edge_m) {
    for (int wall = 0; wall < kWallCount; ++wall) {
      planes_.push_back(std::make_unique<btStaticPlaneShape>(to_bullet(inward_normal(wall)),
                                                             static_cast<btScalar>(-half_edge_m)));
      btRigidBody::btRigidBodyConstructionInfo info(0.0F, nullptr, planes_.back().get());
      info.m_restitution = restitution_;
      info.m_friction = 0.0F;
      bodies_.push_back(std::make_unique<btRigidBody>(info));
      bullet_.world.addRigidBody(bodies_.back().get());
    }
  }

  BodyModel model_;
  PrincipalShape principal_;
  BulletTriangles triangles_;
  btScalar restitution_;
  std::unique_ptr<btCollisionShape> shape_;
  std::vector<std::unique_ptr<btStaticPlaneShape>> planes_;
  BulletWorld bullet_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_;
  std::size_t count_{0};  ///< of bodies_, those that are no walls
};

class BulletPair final : public PeerPair {
 public:
  BulletPair(const TriangleMesh& mesh, bool hulls)
      : triangles_(mesh), shape_(hulls ? hull_of(mesh) : gimpact_of(triangles_)) {
    a_.setCollisionShape(shape_.get());
    b_.setCollisionShape(shape_.get());
    for (btCollisionObject* object : {&a_, &b_}) {
      object->setCollisionFlags(0);  // two that stand still would be left out
      object->setActivationState(DISABLE_DEACTIVATION);
      bullet_.world.addCollisionObject(object, btBroadphaseProxy::DefaultFilter,
                                       btBroadphaseProxy::AllFilter);
    }
  }
  ~BulletPair() override {
    bullet_.world.removeCollisionObject(&a_);
    bullet_.world.removeCollisionObject(&b_);
  }
  BulletPair(const BulletPair&) = delete;
  BulletPair& operator=(const BulletPair&) = delete;

  int contacts_at(const Pose& b) override {
    b_.setWorldTransform(to_bullet(b));
    bullet_.world.performDiscreteCollisionDetection();
    int count = 0;
    for (int i = 0; i < bullet_.dispatcher.getNumManifolds(); ++i) {
      const btPersistentManifold& manifold = *bullet_.dispatcher.getManifoldByIndexInternal(i);
      for (int point = 0; point < manifold.getNumContacts(); ++point) {
        count += manifold.getContactPoint(point).getDistance() <= 0.0F ? 1 : 0;
      }
    }
    return count;
  }

 private:
  BulletTriangles triangles_;
  std::unique_ptr<btCollisionShape> shape_;
  btCollisionObject a_;
  btCollisionObject b_;
  BulletWorld bullet_;
};

}  // namespace

std::unique_ptr<PeerCrowd> bullet_of_hulls(const CrowdShape& shape, const BenchCrowdStart& start,
                                           double restitution) {
  return std::make_unique<BulletCrowd>(shape, start, restitution, /*hulls=*/true);
}

std::unique_ptr<PeerCrowd> bullet_of_triangles(const CrowdShape& shape,
                                               const BenchCrowdStart& start, double restitution) {
  return std::make_unique<BulletCrowd>(shape, start, restitution, /*hulls=*/false);
}

std::unique_ptr<PeerPair> bullet_hull_pair(const TriangleMesh& mesh) {
  return std::make_unique<BulletPair>(mesh, /*hulls=*/true);
}

std::unique_ptr<PeerPair> bullet_triangle_pair(const TriangleMesh& mesh) {
  return std::make_unique<BulletPair>(mesh, /*hulls=*/false);
}

}  // namespace impetus
