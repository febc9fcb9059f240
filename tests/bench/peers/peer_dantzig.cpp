// SPDX-License-Identifier: MIT
#include "tests/bench/peers/peer_dantzig.hpp"

#include <BulletDynamics/MLCPSolvers/btDantzigSolver.h>

#include "engine/dynamics/impulse.hpp"
#include "tests/bench/thread_time.hpp"

namespace impetus {
namespace {

using Row = Eigen::Matrix<double, 12, 1>;

/// Of a contact: J, and J M⁻¹.
struct ContactRows {
  Row jacobian;
  Row by_mass;
};

ContactRows rows_of(const Contact& contact, const ContactProblem& problem) {
  ContactRows rows;
  for (int side = 0; side < 2; ++side) {
    const auto body = static_cast<std::size_t>(side);
    const double sign = side == 0 ? 1.0 : -1.0;
    const Vector3 arm = contact.touch.point - problem.states[body].pose.position;
    const Vector3 along = sign * contact.touch.normal;
    const Vector3 about = sign * arm.cross(contact.touch.normal);
    rows.jacobian.segment<3>(6 * side) = along;
    rows.jacobian.segment<3>(6 * side + 3) = about;
    rows.by_mass.segment<3>(6 * side) = problem.models[body].inverse_mass * along;
    rows.by_mass.segment<3>(6 * side + 3) =
        world_inverse_inertia(problem.models[body], problem.states[body]) * about;
  }
  return rows;
}

}  // namespace

DantzigCost dantzig_cost(const ContactProblem& problem, double restitution, double looking_ns) {
  constexpr double kMixing = 1e-3;
  const auto count = static_cast<int>(problem.contacts.size());
  std::vector<ContactRows> rows;
  for (const Contact& contact : problem.contacts) {
    rows.push_back(rows_of(contact, problem));
  }
  btMatrixXu matrix(count, count);
  btVectorXu wanted(count);
  btVectorXu impulses(count);
  btVectorXu least(count);
  btVectorXu most(count);
  btAlignedObjectArray<int> limits;
  double trace = 0.0;
  for (const ContactRows& row : rows) {
    trace += row.by_mass.dot(row.jacobian);
  }
  for (int i = 0; i < count; ++i) {
    const ContactRows& row = rows[static_cast<std::size_t>(i)];
    for (int k = 0; k < count; ++k) {
      const double mixing = i == k ? kMixing * trace / count : 0.0;
      matrix.setElem(i, k,
                     static_cast<btScalar>(
                         row.by_mass.dot(rows[static_cast<std::size_t>(k)].jacobian) + mixing));
    }
    const double speed = separation_speed(problem.contacts[static_cast<std::size_t>(i)],
                                          problem.models, problem.states);
    wanted[i] = static_cast<btScalar>(-(1.0 + restitution) * speed);
    impulses[i] = 0.0F;
    least[i] = 0.0F;
    most[i] = BT_INFINITY;
    limits.push_back(-1);
  }
  static btDantzigSolver solver;  // its buffers stay from problem to problem
  const std::int64_t start_ns = thread_cpu_ns();
  const bool solved = solver.solveMLCP(matrix, wanted, impulses, least, most, limits, 1);
  return {(static_cast<double>(thread_cpu_ns() - start_ns) - looking_ns) * 1e-3, solved};
}

}  // namespace impetus
