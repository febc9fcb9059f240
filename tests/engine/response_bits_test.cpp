// The response that looks at nothing twice, in arrays that outlive a step, gives the bits of the
// methods as they read.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#include "engine/dynamics/responder.hpp"
#include "tests/engine/plain_response.hpp"
#include "tests/engine/response_problems.hpp"

namespace impetus {
namespace {

constexpr std::uint64_t kSeed = 2002;

/// Of zeros of either sign too: the hash tells them apart.
bool same_bits(const double* x, const double* y, std::size_t count) {
  return std::memcmp(x, y, count * sizeof(double)) == 0;
}

void expect_same_bits(const std::vector<double>& found, const std::vector<double>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  ASSERT_TRUE(found.empty() || same_bits(found.data(), expected.data(), found.size()));
}

ResponseResult plain_response(ResponseMethod method, ResponseProblem& problem) {
  return method == ResponseMethod::kInTurn
             ? plain::respond(problem.contacts, problem.restitutions, problem.models,
                              problem.states)
             : plain::respond_together(problem.contacts, problem.restitutions, problem.models,
                                       problem.states);
}

void expect_bits_of_plain(Responder& responder, ResponseMethod method, ResponseProblem problem) {
  ResponseProblem plain = problem;
  const ResponseResult expected = plain_response(method, plain);
  ResponseRules rules;
  rules.method = method;
  const ResponseResult& found = responder.respond(problem.contacts, problem.restitutions, rules,
                                                  problem.models, problem.states);
  expect_same_bits(found.impulse_Ns, expected.impulse_Ns);
  expect_same_bits(found.approach_m_s, expected.approach_m_s);
  ASSERT_TRUE(same_bits(&found.fastest_m_s, &expected.fastest_m_s, 1));
  ASSERT_TRUE(same_bits(&found.residual_approach_m_s, &expected.residual_approach_m_s, 1));
  for (std::size_t body = 0; body < problem.states.size(); ++body) {
    const BodyState& x = problem.states[body];
    const BodyState& y = plain.states[body];
    ASSERT_TRUE(same_bits(x.linear_momentum.data(), y.linear_momentum.data(), 3)) << body;
    ASSERT_TRUE(same_bits(x.angular_momentum.data(), y.angular_momentum.data(), 3)) << body;
  }
}

/// Balls in a heap, each touching some of those before it at up to `points` points; all fall.
ResponseProblem random_heap(RandomStream& random, int balls, std::uint64_t points) {
  ResponseProblem heap;
  for (std::int32_t i = 0; i < balls; ++i) {
    heap.models.push_back(ball(0.5, uniform_in(random, 0.5, 2.0)));
    heap.states.push_back(
        moving(heap.models.back(), random_in_cube(random, 3.0), random_in_cube(random, 1.0)));
    heap.states.back().pose.orientation = random_turn(random);
    heap.states.back().angular_momentum = random_in_cube(random, 0.2);
    for (std::uint64_t left = i == 0 ? 0 : 1 + random.below(points); left > 0; --left) {
      Contact contact;
      contact.bodies = {static_cast<std::int32_t>(random.below(static_cast<std::uint64_t>(i))), i};
      if (random.below(8) == 0) {
        contact.bodies = {i, wall_index(static_cast<int>(random.below(6)))};
      }
      contact.touch.normal = random_direction(random);
      contact.touch.point = random_in_cube(random, 3.0);
      heap.contacts.push_back(contact);
      heap.restitutions.push_back(random.below(3) == 0 ? 0.0 : random.uniform());
    }
  }
  return heap;
}

/// Two balls that meet at `count` points, as two bodies of many nodes do.
ResponseProblem random_pair(RandomStream& random, std::uint64_t count) {
  ResponseProblem pair;
  for (const double side : {-1.0, 1.0}) {
    pair.models.push_back(ball(1.0, uniform_in(random, 0.5, 2.0)));
    pair.states.push_back(moving(pair.models.back(), {0.9 * side, 0.0, 0.0},
                                 Vector3(-side, 0.0, 0.0) + random_in_cube(random, 0.5)));
    pair.states.back().angular_momentum = random_in_cube(random, 0.5);
  }
  for (; count > 0; --count) {
    Contact contact;
    contact.bodies = {0, 1};
    contact.touch.normal = (random_in_cube(random, 0.5) - Vector3::UnitX()).normalized();
    contact.touch.point = random_in_cube(random, 0.5);
    pair.contacts.push_back(contact);
    pair.restitutions.push_back(random.uniform());
  }
  return pair;
}

class ResponseBits : public testing::TestWithParam<ResponseMethod> {};

TEST_P(ResponseBits, AreThoseOfThePlainMethodForAnyProblem) {
  RandomStream random(kSeed, "any");
  Responder responder;
  for (int trial = 0; trial < 10'000; ++trial) {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", problem " + std::to_string(trial));
    expect_bits_of_plain(responder, GetParam(), random_problem(random));
    if (HasFatalFailure()) {
      return;
    }
  }
}

TEST_P(ResponseBits, AreThoseOfThePlainMethodForHeapsAndPairsOfManyContacts) {
  RandomStream random(kSeed, "heaps");
  Responder responder;
  for (int trial = 0; trial < 500; ++trial) {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", problem " + std::to_string(trial));
    const auto size = static_cast<int>(random.below(20));
    expect_bits_of_plain(responder, GetParam(), random_heap(random, 2 + size, 3));
    expect_bits_of_plain(responder, GetParam(), random_pair(random, 1 + random.below(64)));
    if (HasFatalFailure()) {
      return;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(BothMethods, ResponseBits,
                         testing::Values(ResponseMethod::kInTurn, ResponseMethod::kTogether),
                         [](const auto& method) {
                           return method.param == ResponseMethod::kInTurn ? "InTurn" : "Together";
                         });

TEST(NearestVelocities, AreToTheBitThoseOfThePlainMethod) {
  RandomStream random(kSeed, "projection");
  int given_up = 0;
  for (int trial = 0; trial < 2'000; ++trial) {
    const std::size_t bodies = 1 + random.below(4);
    const auto random6 = [&] {
      Vector6 result;
      result.head<3>() = random_in_cube(random, 1.0);
      result.tail<3>() = random_in_cube(random, 1.0);
      return result;
    };
    std::vector<Vector6> u;
    for (std::size_t body = 0; body < bodies; ++body) {
      u.push_back(random6());
    }
    std::vector<ConstraintRow> rows;
    for (std::uint64_t left = random.below(40); left > 0; --left) {
      ConstraintRow row;
      row.a = {static_cast<std::int32_t>(random.below(bodies)), random6()};
      if (random.below(3) > 0) {
        row.b = {static_cast<std::int32_t>(random.below(bodies)), random6()};
      }
      row.bound = uniform_in(random, -1.0, 0.3);
      rows.push_back(random.below(6) == 0 && !rows.empty() ? rows.back() : row);
    }
    std::vector<Vector6> expected_u = u;
    const NearestVelocities expected = plain::project(rows, expected_u, 1e-12);
    const NearestVelocities found = project(rows, u, 1e-12);
    ASSERT_EQ(found.outcome, expected.outcome) << "seed " << kSeed << ", problem " << trial;
    expect_same_bits(found.multipliers, expected.multipliers);
    for (std::size_t body = 0; body < bodies; ++body) {
      ASSERT_TRUE(same_bits(u[body].data(), expected_u[body].data(), 6)) << trial;
    }
    given_up += found.outcome == Projection::kGaveUp ? 1 : 0;
  }
  EXPECT_GT(given_up, 10) << "problems without a solution are among them";
}

}  // namespace
}  // namespace impetus
