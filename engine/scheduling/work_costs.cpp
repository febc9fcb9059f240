// SPDX-License-Identifier: MIT
#include "engine/scheduling/work_costs.hpp"

namespace impetus::inline scheduling {
namespace {

std::string problem_of(const char* what, std::int64_t least, std::int64_t cost) {
  if (cost >= least && cost <= kGreatestCost) {
    return "";
  }
  return "work costs: expected " + std::to_string(least) + " to " + std::to_string(kGreatestCost) +
         " units for " + what + ", got " + std::to_string(cost);
}

}  // namespace

std::string problem_of(const WorkCosts& costs) {
  for (const std::string& problem :
       {problem_of("a sphere test", 1, costs.sphere_test),
        problem_of("a volume test", 1, costs.volume_test), problem_of("modelling", 0, costs.model),
        problem_of("response", 0, costs.response),
        problem_of("modelling volumes", 0, costs.volume_model),
        problem_of("response of figures", 0, costs.hinged_response)}) {
    if (!problem.empty()) {
      return problem;
    }
  }
  return "";
}

}  // namespace impetus::inline scheduling
