// Random problems for the response: several bodies, redundant contacts, any masses.
// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tests/engine/builders.hpp"
#include "tests/engine/once.hpp"

namespace impetus {

struct ResponseProblem {
  std::vector<BodyModel> models;
  std::vector<BodyState> states;
  std::vector<Contact> contacts;
  std::vector<double> restitutions;
};

/// 2 to 5 bodies and 1 to 12 contacts: mass ratios to 1e6, restitutions 0 to 1, contacts doubled,
/// fixed bodies and walls among them.
inline ResponseProblem random_problem(RandomStream& random) {
  ResponseProblem problem;
  const auto bodies = static_cast<std::int32_t>(2 + random.below(4));
  for (std::int32_t i = 0; i < bodies; ++i) {
    double mass_kg = 1.0;
    for (std::uint64_t tens = random.below(4); tens > 0; --tens) {
      mass_kg *= random.below(2) == 0 ? 10.0 : 0.1;
    }
    BodyModel model = ball(1.0, mass_kg);
    const Vector3 axes(uniform_in(random, 0.5, 4.0), uniform_in(random, 0.5, 4.0),
                       uniform_in(random, 0.5, 4.0));
    model.inverse_inertia = (axes / mass_kg).asDiagonal();
    if (i > 0 && random.below(8) == 0) {
      model = fixed_ball(1.0);
    }
    problem.models.push_back(model);
    BodyState state = resting_at(random_in_cube(random, 2.0));
    state.pose.orientation = random_turn(random);
    if (model.inverse_mass > 0.0) {
      state.linear_momentum = mass_kg * random_in_cube(random, 1.0);
      state.angular_momentum = mass_kg * random_in_cube(random, 0.5);
    }
    problem.states.push_back(state);
  }
  for (std::uint64_t left = 1 + random.below(12); left > 0; --left) {
    Contact contact;
    contact.bodies.a = 0;
    contact.bodies.b = static_cast<std::int32_t>(1 + random.below(bodies - 1));
    if (random.below(3) == 0) {
      contact.bodies.a = static_cast<std::int32_t>(random.below(bodies - 1));
      contact.bodies.b = bodies - 1;
    }
    if (random.below(10) == 0) {
      contact.bodies.b = wall_index(static_cast<int>(random.below(6)));
    }
    contact.touch.normal = random_direction(random);
    contact.touch.point = random_in_cube(random, 2.0);
    if (!problem.contacts.empty() && random.below(4) == 0) {
      contact = problem.contacts.back();  // redundant
    }
    problem.contacts.push_back(contact);
    problem.restitutions.push_back(random.below(3) == 0 ? 1.0 : random.uniform());
  }
  return problem;
}

/// `count` equal balls in a row that touch; the first comes at 1 m/s, restitution 1.
inline ResponseProblem newtons_cradle(int count) {
  ResponseProblem cradle;
  for (int i = 0; i < count; ++i) {
    cradle.models.push_back(ball(0.5, 1.0));
    cradle.states.push_back(resting_at({static_cast<double>(i), 0.0, 0.0}));
    if (i > 0) {
      Contact contact;
      contact.bodies = {i - 1, i};
      contact.touch.normal = -Vector3::UnitX();
      contact.touch.point = Vector3(i - 0.5, 0.0, 0.0);
      cradle.contacts.push_back(contact);
      cradle.restitutions.push_back(1.0);
    }
  }
  cradle.states.front().linear_momentum.x() = 1.0;
  return cradle;
}

inline double energy_of(const ResponseProblem& problem) {
  double sum = 0.0;
  for (std::size_t body = 0; body < problem.models.size(); ++body) {
    sum += kinetic_energy(problem.models[body], problem.states[body]);
  }
  return sum;
}

/// Solves `count` random problems and checks what must hold of each.
inline void expect_sound_responses(std::uint64_t seed, int count) {
  RandomStream random(seed, "responses");
  for (int trial = 0; trial < count; ++trial) {
    ResponseProblem problem = random_problem(random);
    const double before_J = energy_of(problem);
    Vector3 momentum = Vector3::Zero();
    double size = 0.0;
    for (const BodyState& state : problem.states) {
      momentum += state.linear_momentum;
      size += state.linear_momentum.norm();
    }
    const ResponseResult result =
        respond_together(problem.contacts, problem.restitutions, problem.models, problem.states);
    ASSERT_LE(energy_of(problem), before_J * (1.0 + 1e-12)) << "seed " << seed << ", " << trial;
    ASSERT_EQ(result.residual_approach_m_s, 0.0)
        << "seed " << seed << ", problem " << trial << ", fastest " << result.fastest_m_s;
    const bool closed =
        std::none_of(problem.contacts.begin(), problem.contacts.end(),
                     [](const Contact& contact) { return is_wall(contact.bodies.b); }) &&
        std::all_of(problem.models.begin(), problem.models.end(),
                    [](const BodyModel& model) { return model.inverse_mass > 0.0; });
    if (closed) {
      Vector3 after = Vector3::Zero();
      for (const BodyState& state : problem.states) {
        after += state.linear_momentum;
        size += state.linear_momentum.norm();
      }
      // Each push rounds by its own size, and redundant contacts may push hard against each other.
      for (const double impulse_Ns : result.impulse_Ns) {
        size += impulse_Ns;
      }
      ASSERT_LE((after - momentum).norm(), 1e-13 * size) << "seed " << seed << ", " << trial;
    }
    for (const double impulse_Ns : result.impulse_Ns) {
      ASSERT_GE(impulse_Ns, 0.0);
    }
  }
}

}  // namespace impetus
