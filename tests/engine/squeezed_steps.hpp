// Steps of which any phase may be cut anywhere, and what must hold of each.
// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <optional>

#include "tests/engine/crowds.hpp"

namespace impetus {

/// Grants phase after phase all, nothing, or a few units.
inline WorkGrants random_grants(RandomStream& random) {
  WorkGrants grants;
  for (std::int64_t& units : grants.units) {
    const std::uint64_t kind = random.below(4);
    units = kind == 0   ? 0
            : kind == 1 ? kUnlimitedTests
                        : static_cast<std::int64_t>(random.below(kind == 2 ? 20 : 2'000));
  }
  return grants;
}

/// Asks what it is given, and keeps the most that each phase was granted of what it asked for.
class WatchedWork final : public WorkMeter {
 public:
  explicit WatchedWork(const WorkGrants& grants) : grants_(grants), meter_(grants) {}

  std::int64_t request(WorkPhase phase, std::int64_t total, std::int64_t reserved) override {
    const std::int64_t answer = meter_.request(phase, total, reserved);
    refused |= total > answer && phase != WorkPhase::kRefinement;
    EXPECT_LE(std::min(total, answer), grants_.of(phase));
    return answer;
  }

  bool refused{false};

 private:
  WorkGrants grants_;
  FixedWork meter_;
};

inline double kinetic_energy_of_all(const World& world) {
  double energy_J = 0.0;
  for (std::size_t body = 0; body < world.states().size(); ++body) {
    energy_J += kinetic_energy(world.models()[body], world.states()[body]);
  }
  return energy_J;
}

/// How often something of a step was refused, and what that was.
struct SqueezedSteps {
  int steps_cut{0};
  std::uint32_t degradations{0};
};

/// Steps a crowd under random grants, beside a replay from what it logs, which is now and then a
/// new copy. What is asked of every step: the same bits again; no phase does more than it was
/// granted; no energy gained; nobody's centre beyond a wall. A rotation that is not kept exactly
/// may swing by `swing` of the energy.
inline void expect_squeezed_steps_hold(RandomStream& random, World live, int steps, double swing,
                                       SqueezedSteps& seen) {
  std::optional<World> replay(live);
  for (int step = 0; step < steps; ++step) {
    const double before_J = kinetic_energy_of_all(live);
    if (step % 5 == 4) {
      replay.emplace(live);
    }
    WatchedWork meter(random_grants(random));
    const StepReport shown = live.step(looking_ahead(), meter);
    FixedWork logged(grants_of(shown));
    const StepReport& again = replay->step(looking_ahead(), logged);
    ASSERT_EQ(again.state.hash, shown.state.hash) << "step " << step;
    ASSERT_EQ(again.work_floor, shown.work_floor) << "step " << step;
    ASSERT_EQ(again.work_spent, shown.work_spent) << "step " << step;
    ASSERT_EQ(again.degradations, shown.degradations) << "step " << step;
    ASSERT_EQ(again.grants, shown.grants) << "step " << step;
    ASSERT_EQ(shown.grants.cut_beyond_refinement(), meter.refused) << "step " << step;
    ASSERT_LE(kinetic_energy_of_all(live), before_J * (1.0 + swing)) << "step " << step;
    ASSERT_LE(farthest_outside_m(live), 1e-9) << "step " << step;
    seen.steps_cut += meter.refused ? 1 : 0;
    seen.degradations |= shown.degradations;
  }
}

}  // namespace impetus
