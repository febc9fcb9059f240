// SPDX-License-Identifier: MIT
#include "experiments/trade/crowds/trajectory.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace impetus::inline trade {

std::int64_t count_steps(const StagedScene& scene, double longest_s) {
  return std::llround(std::floor(std::min(scene.duration_s, longest_s) * scene.step_hz));
}

Trajectory::Trajectory(const StagedScene& scene, double sampled_every_s, std::uint64_t seed)
    : run_(scene, seed),
      seed_(seed),
      looks_(seed, "looks"),
      every_(std::max<std::int64_t>(1, std::llround(sampled_every_s * scene.step_hz))) {
  run_.world().set_schedule({});
}

void Trajectory::look() {
  const std::int64_t next = run_.number() + 1;
  if (next % every_ == 0) {
    const std::vector<BodyState>& states = run_.world().states();
    fixation_ = projected(run_.viewer_at(next), states[looks_.below(states.size())].pose.position);
  }
  region_ = run_.next_region(fixation_);
}

Moment Trajectory::moment() const {
  return {run_, fixation_, region_, derived_seed(seed_, std::to_string(run_.number() + 1))};
}

const StepReport& Trajectory::step() {
  FixedWork all(kUnlimitedTests);
  return run_.step(fixation_, region_, all);
}

}  // namespace impetus::inline trade
