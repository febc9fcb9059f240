// SPDX-License-Identifier: MIT
#include <ode/ode.h>

#include <array>
#include <limits>
#include <stdexcept>

#include "engine/volumes/closed_cube.hpp"
#include "tests/bench/peers/peer_scene.hpp"

namespace impetus {
namespace {

constexpr int kContactsOfPair = 16;

/// ODE is started once, and ends with the program.
void start_ode() {
  static const bool started = [] {
    dInitODE2(0);
    dAllocateODEDataForThread(dAllocateMaskAll);
    return true;
  }();
  static_cast<void>(started);
}

std::array<dReal, 4> to_ode(const Quaternion& q) { return {q.w(), q.x(), q.y(), q.z()}; }

Vector3 from_ode(const dReal* v) { return {v[0], v[1], v[2]}; }

class OdeScene final : public PeerScene {
 public:
  OdeScene(const ExtremeScene& scene, bool quick)
      : scene_(&scene), quick_(quick), space_(space_for(scene.bodies.size())) {
    const Vector3& gravity = scene.settings.gravity_m_s2;
    dWorldSetGravity(world_, gravity.x(), gravity.y(), gravity.z());
    dWorldSetQuickStepNumIterations(world_, 20);
    for (const ExtremeBody& body : scene.bodies) {
      add(body);
    }
    if (scene.settings.enclosure) {
      const double half_edge_m = std::get<ClosedCube>(*scene.settings.enclosure).half_edge_m;
      for (int wall = 0; wall < kWallCount; ++wall) {
        const Vector3 normal = inward_normal(wall);
        dCreatePlane(space_, normal.x(), normal.y(), normal.z(), -half_edge_m);
      }
    }
  }
  ~OdeScene() override {
    dJointGroupDestroy(contacts_);
    dSpaceDestroy(space_);
    dWorldDestroy(world_);
  }
  OdeScene(const OdeScene&) = delete;
  OdeScene& operator=(const OdeScene&) = delete;

  void step() override {
    dSpaceCollide(space_, this, [](void* self, dGeomID a, dGeomID b) {
      static_cast<OdeScene*>(self)->add_contacts(a, b);
    });
    const int stepped =
        quick_ ? dWorldQuickStep(world_, scene_->step_s) : dWorldStep(world_, scene_->step_s);
    if (stepped == 0) {
      throw std::runtime_error("ODE could not step for want of memory");
    }
    dJointGroupEmpty(contacts_);
  }

  [[nodiscard]] std::vector<MotionSeen> motions() const override {
    std::vector<MotionSeen> motions;
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      const dBodyID body = bodies_[i];
      motions.push_back(scene_->bodies[i].start);
      if (body != nullptr) {
        const dReal* turn = dBodyGetQuaternion(body);
        motions.back() = {
            {from_ode(dBodyGetPosition(body)), Quaternion(turn[0], turn[1], turn[2], turn[3])},
            from_ode(dBodyGetLinearVel(body)),
            from_ode(dBodyGetAngularVel(body))};
      }
    }
    return motions;
  }

  void spoil(std::size_t body) override {
    const dReal bad = std::numeric_limits<dReal>::quiet_NaN();
    dBodySetLinearVel(bodies_[body], bad, bad, bad);
  }

 private:
  /// Its manual recommends the hash space for many bodies; sizes and speeds do not matter to the
  /// simple one.
  static dSpaceID space_for(std::size_t bodies) {
    constexpr std::size_t kFew = 20;
    return bodies < kFew ? dSimpleSpaceCreate(nullptr) : dHashSpaceCreate(nullptr);
  }

  dGeomID geom_of(const ExtremeBody& body) {
    if (const auto* ball = std::get_if<SolidBall>(&body.solid)) {
      return dCreateSphere(space_, ball->radius_m);
    }
    const Vector3& edges_m = std::get<SolidBlock>(body.solid).edges_m;
    return dCreateBox(space_, edges_m.x(), edges_m.y(), edges_m.z());
  }

  void add(const ExtremeBody& body) {
    const dGeomID geom = geom_of(body);
    const Vector3& p = body.start.pose.position;
    const std::array<dReal, 4> turn = to_ode(body.start.pose.orientation);
    bodies_.push_back(nullptr);
    if (body.mass_kg > 0.0) {
      const dBodyID made = dBodyCreate(world_);
      const Vector3 inertia = inertia_of(body);
      dMass mass;
      dMassSetParameters(&mass, body.mass_kg, 0, 0, 0, inertia.x(), inertia.y(), inertia.z(), 0, 0,
                         0);
      dBodySetMass(made, &mass);
      const Vector3& v = body.start.velocity_m_s;
      const Vector3& spin = body.start.spin_rad_s;
      dBodySetLinearVel(made, v.x(), v.y(), v.z());
      dBodySetAngularVel(made, spin.x(), spin.y(), spin.z());
      dBodySetFiniteRotationMode(made, 1);
      dGeomSetBody(geom, made);
      bodies_.back() = made;
    }
    dGeomSetPosition(geom, p.x(), p.y(), p.z());
    dGeomSetQuaternion(geom, turn.data());
  }

  void add_contacts(dGeomID a, dGeomID b) {
    const dBodyID body_a = dGeomGetBody(a);
    const dBodyID body_b = dGeomGetBody(b);
    if (body_a == nullptr && body_b == nullptr) {
      return;
    }
    std::array<dContactGeom, kContactsOfPair> found;
    const int count = dCollide(a, b, kContactsOfPair, found.data(), sizeof(dContactGeom));
    for (int i = 0; i < count; ++i) {
      dContact contact{};
      contact.surface.mode = dContactBounce;
      contact.surface.mu = 0.0;
      contact.surface.bounce = scene_->settings.restitution;
      contact.geom = found[static_cast<std::size_t>(i)];
      dJointAttach(dJointCreateContact(world_, contacts_, &contact), body_a, body_b);
    }
  }

  const ExtremeScene* scene_;
  bool quick_;
  dWorldID world_{dWorldCreate()};
  dSpaceID space_;
  dJointGroupID contacts_{dJointGroupCreate(0)};
  std::vector<dBodyID> bodies_;  ///< null where nothing moves it
};

}  // namespace

std::unique_ptr<PeerScene> ode_scene(const ExtremeScene& scene) {
  start_ode();
  return std::make_unique<OdeScene>(scene, /*quick=*/true);
}

std::unique_ptr<PeerScene> exact_ode_scene(const ExtremeScene& scene) {
  start_ode();
  return std::make_unique<OdeScene>(scene, /*quick=*/false);
}

void empty_mesh_in_ode() {
  start_ode();
  const dTriMeshDataID data = dGeomTriMeshDataCreate();
  const std::array<double, 3> vertices{};
  const std::array<dTriIndex, 3> indices{};
  dGeomTriMeshDataBuildDouble(data, vertices.data(), 3 * sizeof(double), 0, indices.data(), 0,
                              3 * sizeof(dTriIndex));
  const dGeomID mesh = dCreateTriMesh(nullptr, data, nullptr, nullptr, nullptr);
  const dGeomID ball = dCreateSphere(nullptr, 1.0);
  std::array<dContactGeom, kContactsOfPair> found;
  dCollide(mesh, ball, kContactsOfPair, found.data(), sizeof(dContactGeom));
}

}  // namespace impetus
