// SPDX-License-Identifier: MIT
#include <ode/ode.h>

#include <array>
#include <cstdarg>

#include "tests/bench/peers/peer_crowd.hpp"
#include "tests/bench/peers/peer_pair.hpp"

namespace impetus {
namespace {

constexpr int kContactsOfCrowd = 16;  // for each pair
constexpr int kContactsOfPair = 1'000;

/// ODE is started once, and ends with the program.
void start_ode() {
  static const bool started = [] {
    dInitODE2(0);
    // Of full tables, thousands of times: printing would count as its time.
    dSetMessageHandler([](int, const char*, va_list) {});
    dAllocateODEDataForThread(dAllocateMaskAll);
    return true;
  }();
  static_cast<void>(started);
}

/// The arrays that ODE's mesh refers to.
class OdeTriangles {
 public:
  explicit OdeTriangles(const TriangleMesh& mesh) {
    start_ode();
    for (const Vector3& vertex : mesh.vertices) {
      vertices_.insert(vertices_.end(), {vertex.x(), vertex.y(), vertex.z()});
    }
    for (const auto& [a, b, c] : mesh.triangles) {
      indices_.insert(indices_.end(), {a, b, c});
    }
    data_ = dGeomTriMeshDataCreate();
    dGeomTriMeshDataBuildDouble(data_, vertices_.data(), 3 * sizeof(double),
                                static_cast<int>(mesh.vertices.size()), indices_.data(),
                                static_cast<int>(indices_.size()), 3 * sizeof(dTriIndex));
  }
  ~OdeTriangles() { dGeomTriMeshDataDestroy(data_); }
  OdeTriangles(const OdeTriangles&) = delete;
  OdeTriangles& operator=(const OdeTriangles&) = delete;

  dGeomID geom(dSpaceID space) const {
    return dCreateTriMesh(space, data_, nullptr, nullptr, nullptr);
  }

 private:
  std::vector<double> vertices_;
  std::vector<dTriIndex> indices_;
  dTriMeshDataID data_{};
};

class OdeCrowd final : public PeerCrowd {
 public:
  OdeCrowd(const CrowdShape& shape, const BenchCrowdStart& start, double restitution)
      : model_(model_of(shape, shape.coarse)), triangles_(shape.mesh), restitution_(restitution) {
    dWorldSetQuickStepNumIterations(world_, 20);
    const Vector3& gravity = start.gravity_m_s2;
    dWorldSetGravity(world_, gravity.x(), gravity.y(), gravity.z());
    for (const BodyState& state : start.states) {
      add_body(state, shape.mass);
    }
    for (int wall = 0; wall < kWallCount && start.half_edge_m > 0.0; ++wall) {
      const Vector3 normal = inward_normal(wall);
      dCreatePlane(space_, normal.x(), normal.y(), normal.z(), -start.half_edge_m);
    }
  }
  ~OdeCrowd() override {
    dJointGroupDestroy(contacts_);
    dSpaceDestroy(space_);
    dWorldDestroy(world_);
  }
  OdeCrowd(const OdeCrowd&) = delete;
  OdeCrowd& operator=(const OdeCrowd&) = delete;

  void step() override {
    dSpaceCollide(space_, this, [](void* self, dGeomID a, dGeomID b) {
      static_cast<OdeCrowd*>(self)->add_contacts(a, b);
    });
    dWorldQuickStep(world_, kCrowdStep_s);
    dJointGroupEmpty(contacts_);
  }

  [[nodiscard]] std::vector<BodyState> states() const override {
    std::vector<BodyState> states;
    for (const dBodyID body : bodies_) {
      const dReal* position = dBodyGetPosition(body);
      const dReal* turn = dBodyGetQuaternion(body);
      const dReal* speed = dBodyGetLinearVel(body);
      const dReal* spin = dBodyGetAngularVel(body);
      BodyState state;
      state.pose.position = Vector3(position[0], position[1], position[2]);
      state.pose.orientation = Quaternion(turn[0], turn[1], turn[2], turn[3]);
      state.linear_momentum = Vector3(speed[0], speed[1], speed[2]) / model_.inverse_mass;
      state.angular_momentum =
          angular_momentum_at(model_, state.pose.orientation, Vector3(spin[0], spin[1], spin[2]));
      states.push_back(state);
    }
    return states;
  }

 private:
  void add_body(const BodyState& state, const MassProperties& mass) {
    const dBodyID body = dBodyCreate(world_);
    dMass of_body;
    const Matrix3& inertia = mass.inertia;
    dMassSetParameters(&of_body, mass.mass_kg, 0, 0, 0, inertia(0, 0), inertia(1, 1), inertia(2, 2),
                       inertia(0, 1), inertia(0, 2), inertia(1, 2));
    dBodySetMass(body, &of_body);
    const Vector3& p = state.pose.position;
    const Quaternion& q = state.pose.orientation;
    const std::array<dReal, 4> turn{q.w(), q.x(), q.y(), q.z()};
    const Vector3 speed = velocity(model_, state);
    const Vector3 spin = angular_velocity(model_, state);
    dBodySetPosition(body, p.x(), p.y(), p.z());
    dBodySetQuaternion(body, turn.data());
    dBodySetLinearVel(body, speed.x(), speed.y(), speed.z());
    dBodySetAngularVel(body, spin.x(), spin.y(), spin.z());
    dGeomSetBody(triangles_.geom(space_), body);
    bodies_.push_back(body);
  }

  void add_contacts(dGeomID a, dGeomID b) {
    const dBodyID body_a = dGeomGetBody(a);
    const dBodyID body_b = dGeomGetBody(b);
    if (body_a == nullptr && body_b == nullptr) {
      return;
    }
    std::array<dContactGeom, kContactsOfCrowd> found;
    const int count = dCollide(a, b, kContactsOfCrowd, found.data(), sizeof(dContactGeom));
    for (int i = 0; i < count; ++i) {
      dContact contact{};
      contact.surface.mode = dContactBounce;
      contact.surface.mu = 0.0;
      contact.surface.bounce = restitution_;
      contact.geom = found[static_cast<std::size_t>(i)];
      dJointAttach(dJointCreateContact(world_, contacts_, &contact), body_a, body_b);
    }
  }

  BodyModel model_;
  OdeTriangles triangles_;
  double restitution_;
  dWorldID world_{dWorldCreate()};
  dSpaceID space_{dHashSpaceCreate(nullptr)};
  dJointGroupID contacts_{dJointGroupCreate(0)};
  std::vector<dBodyID> bodies_;
};

class OdePair final : public PeerPair {
 public:
  explicit OdePair(const TriangleMesh& mesh)
      : triangles_(mesh), a_(triangles_.geom(nullptr)), b_(triangles_.geom(nullptr)) {}
  ~OdePair() override {
    dGeomDestroy(a_);
    dGeomDestroy(b_);
  }
  OdePair(const OdePair&) = delete;
  OdePair& operator=(const OdePair&) = delete;

  int contacts_at(const Pose& b) override {
    const Quaternion& q = b.orientation;
    const std::array<dReal, 4> turn{q.w(), q.x(), q.y(), q.z()};
    dGeomSetPosition(b_, b.position.x(), b.position.y(), b.position.z());
    dGeomSetQuaternion(b_, turn.data());
    return dCollide(a_, b_, kContactsOfPair, found_.data(), sizeof(dContactGeom));
  }

 private:
  OdeTriangles triangles_;
  dGeomID a_;
  dGeomID b_;
  std::array<dContactGeom, kContactsOfPair> found_{};
};

}  // namespace

std::unique_ptr<PeerCrowd> ode_of_triangles(const CrowdShape& shape, const BenchCrowdStart& start,
                                            double restitution) {
  return std::make_unique<OdeCrowd>(shape, start, restitution);
}

std::unique_ptr<PeerPair> ode_triangle_pair(const TriangleMesh& mesh) {
  return std::make_unique<OdePair>(mesh);
}

}  // namespace impetus
