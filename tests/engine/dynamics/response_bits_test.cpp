// The response that looks at nothing twice, in arrays that outlive a step, gives the bits of the
// methods as they read.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#include "engine/dynamics/responder.hpp"
#include "tests/engine/once.hpp"
#include "tests/engine/plain_response.hpp"
#include "tests/engine/response_scenes.hpp"

namespace impetus::response_bits_test {

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
    const auto size = static_cast<int>(random.below(20)) + (trial % 50 == 0 ? 60 : 0);
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

}  // namespace impetus::response_bits_test
