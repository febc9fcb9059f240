// SPDX-License-Identifier: MIT
#include <btBulletDynamicsCommon.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/volumes/closed_cube.hpp"
#include "tests/bench/peers/peer_scene.hpp"

namespace impetus {
namespace {

btScalar scalar(double x) { return static_cast<btScalar>(x); }

btVector3 to_bullet(const Vector3& v) { return {scalar(v.x()), scalar(v.y()), scalar(v.z())}; }

Vector3 from_bullet(const btVector3& v) { return {v.x(), v.y(), v.z()}; }

btTransform to_bullet(const Pose& pose) {
  const Quaternion& q = pose.orientation;
  return btTransform(btQuaternion(scalar(q.x()), scalar(q.y()), scalar(q.z()), scalar(q.w())),
                     to_bullet(pose.position));
}

double least_half_width_m(const ExtremeBody& body) {
  const auto* ball = std::get_if<SolidBall>(&body.solid);
  return ball != nullptr ? ball->radius_m
                         : 0.5 * std::get<SolidBlock>(body.solid).edges_m.minCoeff();
}

std::unique_ptr<btCollisionShape> shape_of(const ExtremeBody& body) {
  if (const auto* ball = std::get_if<SolidBall>(&body.solid)) {
    return std::make_unique<btSphereShape>(scalar(ball->radius_m));
  }
  constexpr double kUsualMargin_m = 0.04;
  constexpr double kShare = 0.1;
  auto box =
      std::make_unique<btBoxShape>(to_bullet(0.5 * std::get<SolidBlock>(body.solid).edges_m));
  box->setMargin(scalar(std::min(kUsualMargin_m, kShare * least_half_width_m(body))));
  return box;
}

class BulletScene final : public PeerScene {
 public:
  BulletScene(const ExtremeScene& scene, bool continuous)
      : scene_(&scene), restitution_(scalar(std::sqrt(scene.settings.restitution))) {
    world_.setGravity(to_bullet(scene.settings.gravity_m_s2));
    world_.getSolverInfo().m_restitutionVelocityThreshold = scalar(0.0);
    world_.getSolverInfo().m_splitImpulsePenetrationThreshold = scalar(0.0);
    for (const ExtremeBody& body : scene.bodies) {
      shapes_.push_back(shape_of(body));
      add(body, *shapes_.back(), continuous);
    }
    if (scene.settings.enclosure) {
      add_walls(std::get<ClosedCube>(*scene.settings.enclosure).half_edge_m);
    }
  }
  ~BulletScene() override {
    for (const auto& body : bodies_) {
      world_.removeRigidBody(body.get());
    }
  }
  BulletScene(const BulletScene&) = delete;
  BulletScene& operator=(const BulletScene&) = delete;

  void step() override { world_.stepSimulation(scalar(scene_->step_s), /*maxSubSteps=*/0); }

  [[nodiscard]] std::vector<MotionSeen> motions() const override {
    std::vector<MotionSeen> motions;
    for (std::size_t i = 0; i < scene_->bodies.size(); ++i) {
      const btTransform& place = bodies_[i]->getWorldTransform();
      const btQuaternion q = place.getRotation();
      motions.push_back({{from_bullet(place.getOrigin()), Quaternion(q.w(), q.x(), q.y(), q.z())},
                         from_bullet(bodies_[i]->getLinearVelocity()),
                         from_bullet(bodies_[i]->getAngularVelocity())});
    }
    return motions;
  }

  void spoil(std::size_t body) override {
    const btScalar bad = std::numeric_limits<btScalar>::quiet_NaN();
    bodies_[body]->setLinearVelocity({bad, bad, bad});
  }

 private:
  void add(const ExtremeBody& body, btCollisionShape& shape, bool continuous) {
    btRigidBody& added = add_body(body.mass_kg, shape, inertia_of(body), body.start.pose);
    added.setLinearVelocity(to_bullet(body.start.velocity_m_s));
    added.setAngularVelocity(to_bullet(body.start.spin_rad_s));
    if (continuous && body.mass_kg > 0.0) {
      constexpr double kSwept = 0.9;
      constexpr double kMoved = 0.5;
      added.setCcdSweptSphereRadius(scalar(kSwept * least_half_width_m(body)));
      added.setCcdMotionThreshold(scalar(kMoved * least_half_width_m(body)));
    }
  }

  btRigidBody& add_body(double mass_kg, btCollisionShape& shape, const Vector3& inertia,
                        const Pose& pose) {
    btRigidBody::btRigidBodyConstructionInfo info(scalar(mass_kg), nullptr, &shape,
                                                  to_bullet(inertia));
    info.m_startWorldTransform = to_bullet(pose);
    info.m_restitution = restitution_;
    info.m_friction = scalar(0.0);
    bodies_.push_back(std::make_unique<btRigidBody>(info));
    bodies_.back()->setActivationState(DISABLE_DEACTIVATION);
    world_.addRigidBody(bodies_.back().get());
    return *bodies_.back();
  }

  void add_walls(double half_edge_m) {
    for (int wall = 0; wall < kWallCount; ++wall) {
      shapes_.push_back(std::make_unique<btStaticPlaneShape>(to_bullet(inward_normal(wall)),
                                                             scalar(-half_edge_m)));
      add_body(0.0, *shapes_.back(), Vector3::Zero(), {});
    }
  }

  const ExtremeScene* scene_;
  btScalar restitution_;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broadphase_;
  btSequentialImpulseConstraintSolver solver_;
  btDiscreteDynamicsWorld world_{&dispatcher_, &broadphase_, &solver_, &configuration_};
  std::vector<std::unique_ptr<btCollisionShape>> shapes_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_;  ///< the scene's, then the walls
};

}  // namespace

std::unique_ptr<PeerScene> bullet_scene(const ExtremeScene& scene) {
  return std::make_unique<BulletScene>(scene, /*continuous=*/false);
}

std::unique_ptr<PeerScene> continuous_bullet_scene(const ExtremeScene& scene) {
  return std::make_unique<BulletScene>(scene, /*continuous=*/true);
}

void empty_mesh_in_bullet() {
  btTriangleMesh none;
  btBvhTriangleMeshShape mesh(&none, /*useQuantizedAabbCompression=*/true);
  btSphereShape ball(scalar(1.0));
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btCollisionWorld world(&dispatcher, &broadphase, &configuration);
  btCollisionObject first;
  btCollisionObject second;
  first.setCollisionShape(&mesh);
  second.setCollisionShape(&ball);
  world.addCollisionObject(&first);
  world.addCollisionObject(&second);
  world.performDiscreteCollisionDetection();
  world.removeCollisionObject(&first);
  world.removeCollisionObject(&second);
}

}  // namespace impetus
