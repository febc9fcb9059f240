// What became of a scene at an extreme: the figures that promises are about, kept while it runs.
//
// It looks at motions alone, so that any engine's course can be measured as ours is.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "experiments/extremes/extreme_scene.hpp"

namespace impetus::inline extremes {

/// Keeps the figures of one scene, step by step.
class Course {
 public:
  /// `scene` must outlive it.
  explicit Course(const ExtremeScene& scene);

  /// Looks at all bodies after a step, in the order of the scene.
  void look(std::span<const MotionSeen> bodies);

  /// This engine's own word on the step.
  void note(const StepReport& report);

  [[nodiscard]] const ExtremeScene& scene() const { return *scene_; }
  [[nodiscard]] const MotionSeen& start(std::size_t body) const {
    return scene_->bodies[body].start;
  }
  [[nodiscard]] const MotionSeen& last(std::size_t body) const { return last_[body]; }
  [[nodiscard]] std::int64_t steps() const { return steps_; }

  /// Whether every number that was seen was finite.
  [[nodiscard]] bool finite() const { return finite_; }

  /// Kinetic, and potential where there is gravity (J).
  [[nodiscard]] double start_energy_J() const { return start_energy_J_; }
  [[nodiscard]] double most_energy_J() const { return most_energy_J_; }
  [[nodiscard]] double least_energy_J() const { return least_energy_J_; }

  /// Of all bodies, at its furthest from that at the start (N s); and the sum of the sizes of all
  /// momenta at the start.
  [[nodiscard]] double momentum_drift_Ns() const { return momentum_drift_Ns_; }
  [[nodiscard]] double start_momentum_Ns() const { return start_momentum_Ns_; }

  /// The least and the greatest coordinates that the body's centre had.
  [[nodiscard]] const Vector3& least_m(std::size_t body) const { return least_m_[body]; }
  [[nodiscard]] const Vector3& greatest_m(std::size_t body) const { return greatest_m_[body]; }

  /// How far the length of any orientation was from one.
  [[nodiscard]] double unit_length_lost() const { return unit_length_lost_; }

  /// Of the reports: all degradations, pairs stopped at entry, collisions, and those that began.
  [[nodiscard]] std::uint32_t degradations() const { return degradations_; }
  [[nodiscard]] std::int64_t stopped() const { return stopped_; }
  [[nodiscard]] std::int64_t collisions() const { return collisions_; }
  [[nodiscard]] std::int64_t began() const { return began_; }

 private:
  [[nodiscard]] double energy_J(std::span<const MotionSeen> bodies) const;
  [[nodiscard]] Vector3 momentum_Ns(std::span<const MotionSeen> bodies) const;

  const ExtremeScene* scene_;
  std::vector<Vector3> inertias_;
  std::vector<MotionSeen> last_;
  std::int64_t steps_{0};
  bool finite_{true};
  double start_energy_J_{0.0};
  double most_energy_J_{0.0};
  double least_energy_J_{0.0};
  Vector3 start_sum_Ns_{Vector3::Zero()};
  double start_momentum_Ns_{0.0};
  double momentum_drift_Ns_{0.0};
  std::vector<Vector3> least_m_;
  std::vector<Vector3> greatest_m_;
  double unit_length_lost_{0.0};
  std::uint32_t degradations_{0};
  std::int64_t stopped_{0};
  std::int64_t collisions_{0};
  std::int64_t began_{0};
};

/// The scene's whole course in this engine. `progress` may be empty.
Course run_scene(const ExtremeScene& scene, const Progress& progress = {});

}  // namespace impetus::inline extremes
