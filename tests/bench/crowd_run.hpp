// A crowd stepped by the engine, and what there is to say about it afterwards.
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/world/world.hpp"
#include "tests/bench/crowd_starts.hpp"
#include "tests/bench/thread_time.hpp"

namespace impetus {

/// How a crowd is run.
struct CrowdPlan {
  bool fine{true};  ///< ~500 leaves, else ~64
  double restitution{1.0};
  double budget_ms{0.0};  ///< of the thread's CPU time; 0: everything is refined
  int steps{600};
  Tunnelling tunnelling{Tunnelling::kIgnored};  ///< as the peers do
  Schedule schedule{};
  int most_response_passes{kUnlimitedPasses};
  std::int64_t most_entry_tests{kUnlimitedTests};
};

struct CrowdOutcome {
  Spread step_ms;
  double touching_pairs{0.0};  ///< in a step, mean; walls included
  double contacts{0.0};        ///< responded to in a step, mean
  double tests{0.0};           ///< work spent in a step, mean, in the costs' unit
  double energy_ratio{0.0};    ///< kinetic, of the end to the start
  double speed_m_s{0.0};       ///< of bodies at the end, root mean square
  int escaped{0};              ///< bodies whose centre of mass is beyond a wall at the end
  int overruns{0};             ///< steps with more work than granted and than the floor
  int floors_over{0};          ///< steps whose floor cost more than was granted
  int approaches_left{0};      ///< steps whose response left bodies approaching
  int not_finite{0};
  int stopped{0};                 ///< pairs stopped at entry
  std::int64_t urgent{0};         ///< collisions in list 0 ...
  std::int64_t urgent_finest{0};  ///< ... and those at their finest level
};

World crowd_world(const CrowdShape& shape, const BenchCrowdStart& start, const CrowdPlan& plan);

/// Looks at the cube from four half edges away.
StepInput crowd_input(const BenchCrowdStart& start);

CrowdOutcome run_crowd(const CrowdShape& shape, const BenchCrowdStart& start,
                       const CrowdPlan& plan);

/// Bodies whose centre of mass is beyond a wall of the cube, or nowhere; none without walls.
int escaped_from(double half_edge_m, const std::vector<BodyState>& states);

double kinetic_energy_of(const World& world);  ///< J

}  // namespace impetus
