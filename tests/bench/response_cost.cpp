// SPDX-License-Identifier: MIT
#include "tests/bench/response_cost.hpp"

#include "tests/engine/once.hpp"

namespace impetus {

ResponseCost response_cost(const CrowdShape& shape, ResponseMethod method, int problems) {
  RandomStream random(kProblemSeed, kProblemStream);
  const double looking_ns = clock_cost_ns();
  const std::vector<double> restitutions(kContactsOfProblem, 0.5);
  std::vector<double> samples_us;
  ResponseCost cost;
  for (int i = 0; i < problems; ++i) {
    ContactProblem problem = random_contact_problem(shape, random);
    const std::int64_t start_ns = thread_cpu_ns();
    const ResponseResult result =
        method == ResponseMethod::kInTurn
            ? respond(problem.contacts, restitutions, problem.models, problem.states)
            : respond_together(problem.contacts, restitutions, problem.models, problem.states);
    samples_us.push_back((static_cast<double>(thread_cpu_ns() - start_ns) - looking_ns) * 1e-3);
    cost.left_approaching += result.residual_approach_m_s > 0.0 ? 1 : 0;
  }
  cost.us = spread_of(std::move(samples_us));
  return cost;
}

}  // namespace impetus
