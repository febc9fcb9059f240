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

/// Takes the scene along, as the request says, and looks at each moment that is sampled.
template <typename Request, typename LookAt>
void for_each_moment(const StagedScene& scene, const Request& request, const Progress& progress,
                     const LookAt& look_at) {
  const std::int64_t steps = count_steps(scene, request.longest_s);
  Trajectory trajectory(scene, request.sampled_every_s, request.seed);
  for (std::int64_t step = 1; step <= steps; ++step) {
    trajectory.look();
    if (trajectory.is_sampled()) {
      look_at(trajectory.moment());
      if (progress) {
        progress(static_cast<double>(step) / static_cast<double>(steps));
      }
    }
    static_cast<void>(trajectory.step());
  }
}

}  // namespace impetus::inline trade
