// SPDX-License-Identifier: MIT
#include "tests/bench/contact_problem.hpp"

namespace impetus {

ContactProblem random_contact_problem(const CrowdShape& shape, RandomStream& random) {
  ContactProblem problem;
  problem.models.assign(2, model_of(shape, shape.coarse));
  for (const double height_m : {1.0, -1.0}) {
    BodyState state;
    state.pose.position = Vector3(0.0, height_m, 0.0);
    state.pose.orientation = random_orientation(random);
    const Vector3 falling(0.0, -height_m, 0.0);
    state.linear_momentum = shape.mass.mass_kg * (falling + 0.5 * random_in_unit_cube(random));
    state.angular_momentum = shape.mass.inertia * random_in_unit_cube(random);
    problem.states.push_back(state);
  }
  for (int i = 0; i < kContactsOfProblem; ++i) {
    Contact contact;
    contact.bodies = {0, 1};
    contact.touch.point = 0.5 * random_in_unit_cube(random);
    contact.touch.normal = (Vector3::UnitY() + 0.5 * random_in_unit_cube(random)).normalized();
    contact.touch.depth_m = 0.01;
    problem.contacts.push_back(contact);
  }
  return problem;
}

}  // namespace impetus
