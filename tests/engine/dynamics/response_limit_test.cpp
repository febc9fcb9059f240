// A response with a limit to its passes: nothing changes where it is not reached, and where it is,
// no energy is gained, momentum is kept, and what still approaches is said.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <vector>

#include "engine/dynamics/responder.hpp"
#include "tests/engine/once.hpp"
#include "tests/engine/response_scenes.hpp"

namespace impetus::response_limit_test {

constexpr std::uint64_t kSeed = 1991;

ResponseRules limited(ResponseMethod method, int most_passes) {
  ResponseRules rules;
  rules.method = method;
  rules.most_passes = most_passes;
  return rules;
}

class LimitedResponse : public testing::TestWithParam<ResponseMethod> {
 protected:
  ResponseResult respond(ResponseProblem& problem, int most_passes) {
    return responder_.respond(problem.contacts, problem.restitutions,
                              limited(GetParam(), most_passes), problem.models, problem.states);
  }

 private:
  Responder responder_;
};

TEST_P(LimitedResponse, IsTheUnlimitedOneWhereTheLimitIsNotReached) {
  RandomStream random(kSeed, "not reached");
  for (int trial = 0; trial < 500; ++trial) {
    ResponseProblem problem = random_problem(random);
    ResponseProblem unlimited = problem;
    const ResponseResult expected = respond(unlimited, kUnlimitedPasses);
    const auto enough = static_cast<int>(2 * problem.contacts.size());
    EXPECT_EQ(respond(problem, enough).impulse_Ns, expected.impulse_Ns)
        << "seed " << kSeed << ", problem " << trial;
  }
}

TEST_P(LimitedResponse, GainsNoEnergyKeepsMomentumAndTellsWhatStillApproaches) {
  RandomStream random(kSeed, "reached");
  int approaching = 0;
  for (int trial = 0; trial < 500; ++trial) {
    ResponseProblem problem = random_heap(random, 12, 3);
    std::erase_if(problem.contacts, [](const Contact& each) { return is_wall(each.bodies.b); });
    problem.restitutions.assign(problem.contacts.size(), random.uniform());
    const double before_J = energy_of(problem);
    Vector3 momentum = Vector3::Zero();
    for (const BodyState& state : problem.states) {
      momentum += state.linear_momentum;
    }
    const ResponseResult result = respond(problem, 1 + static_cast<int>(random.below(3)));
    ASSERT_LE(energy_of(problem), before_J * (1.0 + 1e-12)) << "seed " << kSeed << ", " << trial;
    double left_m_s = 0.0;
    for (const Contact& contact : problem.contacts) {
      left_m_s = std::max(left_m_s, -separation_speed(contact, problem.models, problem.states));
    }
    // Below 1e-9 of the fastest it is rounding and is not told.
    ASSERT_NEAR(result.residual_approach_m_s, left_m_s, kNegligibleApproach * result.fastest_m_s);
    for (const BodyState& state : problem.states) {
      momentum -= state.linear_momentum;
    }
    ASSERT_LE(momentum.norm(), 1e-11) << "seed " << kSeed << ", " << trial;
    approaching += result.residual_approach_m_s > 0.0 ? 1 : 0;
  }
  EXPECT_GT(approaching, 100) << "the limit was reached";
}

/// Both problems as one, the contacts of each in their order, in turns that are drawn.
ResponseProblem interleaved(RandomStream& random, const ResponseProblem& x,
                            const ResponseProblem& y) {
  ResponseProblem both{x.models, x.states, {}, {}};
  both.models.insert(both.models.end(), y.models.begin(), y.models.end());
  both.states.insert(both.states.end(), y.states.begin(), y.states.end());
  std::size_t of_x = 0;
  std::size_t of_y = 0;
  while (of_x + of_y < x.contacts.size() + y.contacts.size()) {
    const bool takes_x =
        of_y == y.contacts.size() || (of_x < x.contacts.size() && random.below(3) > 0);
    const ResponseProblem& from = takes_x ? x : y;
    const std::size_t place = takes_x ? of_x++ : of_y++;
    both.contacts.push_back(from.contacts[place]);
    both.restitutions.push_back(from.restitutions[place]);
    if (!takes_x) {
      BodyPair& bodies = both.contacts.back().bodies;
      bodies.a += static_cast<std::int32_t>(x.models.size());
      bodies.b += is_wall(bodies.b) ? 0 : static_cast<std::int32_t>(x.models.size());
    }
  }
  return both;
}

TEST_P(LimitedResponse, OfIslandsWhoseContactsAreMixedIsThatOfEachAlone) {
  RandomStream random(kSeed, "mixed");
  int approaching = 0;
  for (int trial = 0; trial < 500; ++trial) {
    ResponseProblem x = random_heap(random, 12, 3);
    ResponseProblem y = random_heap(random, 12, 3);
    ResponseProblem both = interleaved(random, x, y);
    const int most_passes = 1 + static_cast<int>(random.below(3));
    approaching += respond(x, most_passes).residual_approach_m_s > 0.0 ? 1 : 0;
    respond(y, most_passes);
    respond(both, most_passes);
    for (std::size_t body = 0; body < both.states.size(); ++body) {
      const BodyState& alone =
          body < x.states.size() ? x.states[body] : y.states[body - x.states.size()];
      ASSERT_EQ(both.states[body].linear_momentum, alone.linear_momentum)
          << "seed " << kSeed << ", trial " << trial << ", body " << body;
    }
  }
  EXPECT_GT(approaching, 100) << "the limit was reached";
}

INSTANTIATE_TEST_SUITE_P(BothMethods, LimitedResponse,
                         testing::Values(ResponseMethod::kInTurn, ResponseMethod::kTogether),
                         [](const auto& method) {
                           return method.param == ResponseMethod::kInTurn ? "InTurn" : "Together";
                         });

TEST(ResponseLimit, KeepsTheEnergyOfElasticBodies) {
  // Each elastic impulse keeps it; only the pass without restitution, which is left out, takes any.
  ResponseProblem cradle = newtons_cradle(16);
  const double before_J = energy_of(cradle);
  const ResponseResult result =
      Responder().respond(cradle.contacts, cradle.restitutions, limited(ResponseMethod::kInTurn, 1),
                          cradle.models, cradle.states);
  EXPECT_NEAR(energy_of(cradle), before_J, 1e-14);
  EXPECT_EQ(result.residual_approach_m_s, 0.0) << "one pass in order carries the wave";
  std::reverse(cradle.contacts.begin(), cradle.contacts.end());
  cradle.states = newtons_cradle(16).states;
  const ResponseResult against =
      Responder().respond(cradle.contacts, cradle.restitutions, limited(ResponseMethod::kInTurn, 3),
                          cradle.models, cradle.states);
  EXPECT_NEAR(energy_of(cradle), before_J, 1e-14);
  EXPECT_NEAR(against.residual_approach_m_s, 1.0, 1e-14) << "a pass carries it by a ball";
  EXPECT_NEAR(cradle.states[3].linear_momentum.x(), 1.0, 1e-14);
}

/// What either method gives a row of balls in so few passes that some still approach.
std::array<std::vector<double>, 2> impulses_of_row(int balls) {
  RandomStream random(kSeed, "row");
  ResponseProblem together = newtons_cradle(balls);
  for (BodyState& state : together.states) {
    state.linear_momentum.x() = uniform_in(random, -1.0, 1.0);
  }
  ResponseProblem in_turn = together;
  const auto respond = [](ResponseProblem& problem, ResponseMethod method) {
    return Responder()
        .respond(problem.contacts, problem.restitutions, limited(method, 5), problem.models,
                 problem.states)
        .impulse_Ns;
  };
  return {respond(together, ResponseMethod::kTogether), respond(in_turn, ResponseMethod::kInTurn)};
}

TEST(ResponseLimit, OfALargeIslandIsFoundInTurnWhicheverTheMethod) {
  const auto [together, in_turn] = impulses_of_row(40);
  EXPECT_EQ(together, in_turn);
  const auto [of_few, of_few_in_turn] = impulses_of_row(20);
  EXPECT_NE(of_few, of_few_in_turn) << "a small island is not";
}

/// The response within grants that are less than it asks for.
ResponseResult refused_response(ResponseProblem& problem, ResponseMethod method,
                                const WorkGrants& grants,
                                const std::vector<std::size_t>& by_visibility) {
  FixedWork meter(grants);
  WorkGrants refused;
  ResponseWork work{{meter, WorkPhase::kResponse, refused},
                    {meter, WorkPhase::kVisible, refused},
                    [&] { return std::span(by_visibility); }};
  ResponseRules rules;
  rules.method = method;
  rules.work = &work;
  ResponseResult result = Responder().respond(problem.contacts, problem.restitutions, rules,
                                              problem.models, problem.states);
  EXPECT_EQ(refused, grants);
  return result;
}

TEST(ResponseLimit, EveryIslandThatIsRefusedIsTakenUpByVisibility) {
  for (const ResponseMethod method : {ResponseMethod::kInTurn, ResponseMethod::kTogether}) {
    ResponseProblem pairs = newtons_cradle(6);
    pairs.contacts = {pairs.contacts[0], pairs.contacts[2], pairs.contacts[4]};
    pairs.restitutions.resize(3);
    for (std::size_t ball = 0; ball < 6; ++ball) {
      pairs.states[ball].linear_momentum.x() = ball % 2 == 0 ? 1.0 : -1.0;
    }
    WorkGrants grants;
    grants.of(WorkPhase::kResponse) = 0;
    const ResponseResult result = refused_response(pairs, method, grants, {2, 0, 1});
    EXPECT_EQ(result.residual_approach_m_s, 0.0);
    for (const double impulse_Ns : result.impulse_Ns) {
      EXPECT_GT(impulse_Ns, 0.0);
    }
  }
}

TEST(ResponseLimit, InACornerWallsGiveBackOnceAndThenOnlyHold) {
  ResponseProblem corner{{ball(1.0, 1.0)}, {resting_at(Vector3::Zero())}, {}, {0.5, 0.5}};
  corner.states[0].linear_momentum = {-1.0, -1.0, 0.0};
  const Vector3 slanting(-0.5, std::sqrt(0.75), 0.0);
  corner.contacts = {{{0, wall_index(0)}, {Vector3::Zero(), Vector3::UnitX(), 0.0}},
                     {{0, wall_index(2)}, {Vector3::Zero(), slanting, 0.0}}};
  WorkGrants nothing;
  nothing.of(WorkPhase::kResponse) = 0;
  nothing.of(WorkPhase::kVisible) = 0;
  const ResponseResult result = refused_response(corner, ResponseMethod::kInTurn, nothing, {0, 1});
  EXPECT_NEAR(corner.states[0].linear_momentum.x(), 0.0, 1e-15) << "thrown back at it once more";
  EXPECT_GT(corner.states[0].linear_momentum.dot(slanting), 0.0);
  EXPECT_GT(result.impulse_Ns[0], 1.5) << "of both times";
}

TEST(Resting, ApproachesSlowerThanTheLimitAreGivenNothingBack) {
  for (const ResponseMethod method : {ResponseMethod::kInTurn, ResponseMethod::kTogether}) {
    for (const double resting_m_s : {0.5, 3.0}) {
      ResponseProblem pair = newtons_cradle(2);  // at 1 m/s
      ResponseRules rules = limited(method, kUnlimitedPasses);
      rules.resting_m_s = resting_m_s;
      Responder().respond(pair.contacts, pair.restitutions, rules, pair.models, pair.states);
      const double expected = resting_m_s > 1.0 ? 0.5 : 1.0;
      EXPECT_NEAR(pair.states[1].linear_momentum.x(), expected, 1e-14);
    }
  }
}

}  // namespace impetus::response_limit_test
