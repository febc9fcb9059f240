// Impulses found together: no energy gained, no approach left, momentum kept, waves passed on.
// SPDX-License-Identifier: MIT
#include "tests/engine/once.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/dynamics/nearest_velocities.hpp"
#include "engine/dynamics/responder.hpp"
#include "tests/engine/response_problems.hpp"

namespace impetus::response_test {

constexpr std::uint64_t kSeed = 1983;

TEST(Response, NeverGainsEnergyNeverLeavesAnApproachKeepsMomentum) {
  expect_sound_responses(kSeed, 20'000);
}

TEST(Response, ANewtonsCradleSendsTheMomentumToTheLastBall) {
  for (const int balls : {2, 3, 5, 16, 64}) {
    ResponseProblem cradle = newtons_cradle(balls);
    const ResponseResult result =
        respond_together(cradle.contacts, cradle.restitutions, cradle.models, cradle.states);
    EXPECT_EQ(result.residual_approach_m_s, 0.0);
    for (int ball = 0; ball < balls; ++ball) {
      const double expected = ball == balls - 1 ? 1.0 : 0.0;
      EXPECT_NEAR(cradle.states[static_cast<std::size_t>(ball)].linear_momentum.x(), expected,
                  1e-13)
          << balls << " balls, ball " << ball;
    }
  }
}

TEST(Response, AnEqualOfOneContactIsTheImpulseOfTheThesis) {
  // j = −(1 + ε) v / (1/m_a + 1/m_b + …) for a single contact (eq. 3.1)
  RandomStream random(kSeed, "single");
  for (int trial = 0; trial < 200; ++trial) {
    ResponseProblem problem = random_problem(random);
    problem.contacts.resize(1);
    const double restitution = problem.restitutions.front();
    std::vector<BodyState> in_turn = problem.states;
    const ResponseResult expected = respond(problem.contacts, restitution, problem.models, in_turn);
    const ResponseResult found =
        respond_together(problem.contacts, {restitution}, problem.models, problem.states);
    // The scaled coordinates round a few times more; mass ratios reach 1e6.
    ASSERT_NEAR(found.impulse_Ns[0], expected.impulse_Ns[0], 1e-9 * expected.impulse_Ns[0]);
  }
}

TEST(Response, RedundantContactsShareTheImpulseAndChangeNothing) {
  RandomStream random(kSeed, "redundant");
  for (int trial = 0; trial < 200; ++trial) {
    ResponseProblem once = random_problem(random);
    once.contacts.resize(1);
    once.restitutions.resize(1);
    ResponseProblem often = once;
    for (int copy = 0; copy < 5; ++copy) {
      often.contacts.push_back(once.contacts.front());
      often.restitutions.push_back(once.restitutions.front());
    }
    respond_together(once.contacts, once.restitutions, once.models, once.states);
    const ResponseResult result =
        respond_together(often.contacts, often.restitutions, often.models, often.states);
    EXPECT_EQ(result.residual_approach_m_s, 0.0);
    for (std::size_t body = 0; body < once.states.size(); ++body) {
      const double scale = once.states[body].linear_momentum.norm() + 1e-9;
      ASSERT_LE((once.states[body].linear_momentum - often.states[body].linear_momentum).norm(),
                1e-9 * scale);
    }
  }
}

TEST(Response, BodiesThatNothingMovesStayAndTakeNoPart) {
  ResponseProblem problem = newtons_cradle(3);
  problem.models.back().inverse_mass = 0.0;
  problem.models.back().inverse_inertia.setZero();
  respond_together(problem.contacts, problem.restitutions, problem.models, problem.states);
  EXPECT_EQ(problem.states.back().linear_momentum, Vector3::Zero());
  EXPECT_NEAR(problem.states.front().linear_momentum.x(), -1.0, 1e-13) << "the wave comes back";
}

TEST(Islands, AreConnectedThroughBodiesThatMove) {
  // 0–1  1–2 | 3–4 | 5–wall | 0–6 and 3–6 where 6 is fixed
  std::vector<BodyModel> models(7, ball(1.0, 1.0));
  models[6].inverse_mass = 0.0;
  const auto contact = [](std::int32_t a, std::int32_t b) { return Contact{{a, b}, {}}; };
  const std::vector<Contact> contacts{contact(0, 1), contact(3, 4), contact(5, wall_index(2)),
                                      contact(1, 2), contact(0, 6), contact(3, 6)};
  const std::vector<std::vector<std::size_t>> expected{{0, 3, 4}, {1, 5}, {2}};
  ContactBodies bodies;
  bodies.gather(contacts, models, std::vector<BodyState>(models.size()));
  Islands islands;
  islands.find(bodies);
  std::vector<std::vector<std::size_t>> found;
  for (std::size_t i = 0; i < islands.count(); ++i) {
    found.emplace_back(islands.members(i).begin(), islands.members(i).end());
  }
  EXPECT_EQ(found, expected);
}

TEST(NearestVelocities, IsTheNearestOfAllThatSatisfy) {
  // Karush–Kuhn–Tucker: λ ≥ 0, a·u ≥ b, λ (a·u − b) = 0, u − u⁻ = Σ λ a.
  RandomStream random(kSeed, "projection");
  int many_active = 0;
  for (int trial = 0; trial < 2'000; ++trial) {
    std::vector<ConstraintRow> rows;
    std::vector<Vector6> u(2);
    const auto random6 = [&] {
      Vector6 result;
      result.head<3>() = random_in_cube(random, 1.0);
      result.tail<3>() = random_in_cube(random, 1.0);
      return result;
    };
    u[0] = random6();
    u[1] = random6();
    const std::vector<Vector6> given = u;
    const Vector6 inner = random6();  // satisfies every row, so there is a solution
    const auto count = static_cast<int>(1 + random.below(30));
    for (int i = 0; i < count; ++i) {
      ConstraintRow row{{0, random6()}, {1, random6()}, 0.0};
      row.bound = row.a.direction.dot(inner) + row.b.direction.dot(inner) - random.uniform();
      rows.push_back(row);
    }
    const NearestVelocities found = project(rows, u, 1e-13);
    ASSERT_EQ(found.outcome, Projection::kSolved) << trial;
    std::vector<Vector6> rebuilt = given;
    int active = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const double slack =
          rows[i].a.direction.dot(u[0]) + rows[i].b.direction.dot(u[1]) - rows[i].bound;
      ASSERT_GE(slack, -1e-11) << trial;
      ASSERT_GE(found.multipliers[i], 0.0);
      ASSERT_LE(found.multipliers[i] * slack, 1e-8) << trial;
      rebuilt[0] += found.multipliers[i] * rows[i].a.direction;
      rebuilt[1] += found.multipliers[i] * rows[i].b.direction;
      active += found.multipliers[i] > 0.0 ? 1 : 0;
    }
    ASSERT_LE((rebuilt[0] - u[0]).norm() + (rebuilt[1] - u[1]).norm(), 1e-8) << trial;
    many_active += active > 3 ? 1 : 0;
  }
  EXPECT_GT(many_active, 100);
}

TEST(NearestVelocities, GivesUpWhereNothingSatisfiesAndChangesNothing) {
  Vector6 x = Vector6::Zero();
  x[0] = 1.0;
  std::vector<Vector6> u{Vector6::Zero()};
  const std::vector<ConstraintRow> rows{{{0, x}, {}, 1.0}, {{0, Vector6(-x)}, {}, 1.0}};
  const NearestVelocities found = project(rows, u, 1e-12);
  EXPECT_EQ(found.outcome, Projection::kGaveUp);
  EXPECT_EQ(u.front(), Vector6(Vector6::Zero()));
  EXPECT_EQ(found.multipliers, (std::vector<double>{0.0, 0.0}));
}

}  // namespace impetus::response_test
