// A scene along its trajectory at the finest level, of which every so often a step is tried
// otherwise. The viewer looks at a body that is drawn for each of these steps.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "engine/numerics/random_stream.hpp"
#include "experiments/run/scene_run.hpp"

namespace impetus::inline trade {

/// A step of the trajectory before it is taken, from which whatever is tried starts.
struct Moment {
  const SceneRun& before;
  Fixation fixation;
  std::optional<GazeRegion> region;
  std::uint64_t seed{0};  ///< of what is random in it
};

/// Steps of the scene, or of its first `longest_s` seconds.
std::int64_t count_steps(const StagedScene& scene, double longest_s);

/// Takes the scene along; where the viewer looks follows from `seed`.
class Trajectory {
 public:
  /// Precondition: `sampled_every_s`, of the scene's time, is positive.
  Trajectory(const StagedScene& scene, double sampled_every_s, std::uint64_t seed);

  /// Decides where the viewer looks in the next step; to be called once before each.
  void look();

  /// The next step, before it is taken.
  [[nodiscard]] Moment moment() const;

  /// Takes it, with all the work that there is.
  const StepReport& step();

  /// Whether something is tried on the next step.
  [[nodiscard]] bool is_sampled() const { return (run_.number() + 1) % every_ == 0; }

 private:
  SceneRun run_;
  std::uint64_t seed_;
  RandomStream looks_;
  std::int64_t every_;
  Fixation fixation_;
  std::optional<GazeRegion> region_;
};

}  // namespace impetus::inline trade
