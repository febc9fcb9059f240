// SPDX-License-Identifier: MIT
#include "experiments/extremes/course.hpp"

#include <algorithm>
#include <cmath>

namespace impetus::inline extremes {
namespace {

bool is_finite(const MotionSeen& motion) {
  return motion.pose.position.allFinite() && motion.pose.orientation.coeffs().allFinite() &&
         motion.velocity_m_s.allFinite() && motion.spin_rad_s.allFinite();
}

std::vector<MotionSeen> starts_of(const ExtremeScene& scene) {
  std::vector<MotionSeen> starts;
  for (const ExtremeBody& body : scene.bodies) {
    starts.push_back(body.start);
  }
  return starts;
}

}  // namespace

Course::Course(const ExtremeScene& scene) : scene_(&scene), last_(starts_of(scene)) {
  for (const ExtremeBody& body : scene.bodies) {
    inertias_.push_back(inertia_of(body));
    least_m_.push_back(body.start.pose.position);
    greatest_m_.push_back(body.start.pose.position);
    start_momentum_Ns_ += body.mass_kg * body.start.velocity_m_s.norm();
  }
  start_energy_J_ = energy_J(last_);
  most_energy_J_ = start_energy_J_;
  least_energy_J_ = start_energy_J_;
  start_sum_Ns_ = momentum_Ns(last_);
}

void Course::look(std::span<const MotionSeen> bodies) {
  ++steps_;
  last_.assign(bodies.begin(), bodies.end());
  for (std::size_t body = 0; body < bodies.size(); ++body) {
    const Pose& pose = bodies[body].pose;
    finite_ = finite_ && is_finite(bodies[body]);
    least_m_[body] = least_m_[body].cwiseMin(pose.position);
    greatest_m_[body] = greatest_m_[body].cwiseMax(pose.position);
    unit_length_lost_ =
        std::max(unit_length_lost_, std::abs(pose.orientation.coeffs().norm() - 1.0));
  }
  const double energy = energy_J(bodies);
  most_energy_J_ = std::max(most_energy_J_, energy);
  least_energy_J_ = std::min(least_energy_J_, energy);
  momentum_drift_Ns_ = std::max(momentum_drift_Ns_, (momentum_Ns(bodies) - start_sum_Ns_).norm());
}

void Course::note(const StepReport& report) {
  degradations_ |= report.degradations;
  stopped_ += static_cast<std::int64_t>(report.stopped.size());
  collisions_ += static_cast<std::int64_t>(report.collisions.size());
  began_ += std::count_if(report.collisions.begin(), report.collisions.end(),
                          [](const CollisionReport& collision) { return collision.began; });
}

double Course::energy_J(std::span<const MotionSeen> bodies) const {
  double sum = 0.0;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const double mass_kg = scene_->bodies[i].mass_kg;
    if (mass_kg > 0.0) {
      const Vector3 spin = bodies[i].pose.orientation.conjugate() * bodies[i].spin_rad_s;
      sum += 0.5 * mass_kg * bodies[i].velocity_m_s.squaredNorm() +
             0.5 * spin.dot(inertias_[i].cwiseProduct(spin)) -
             mass_kg * scene_->settings.gravity_m_s2.dot(bodies[i].pose.position);
    }
  }
  return sum;
}

Vector3 Course::momentum_Ns(std::span<const MotionSeen> bodies) const {
  Vector3 sum = Vector3::Zero();
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    sum += scene_->bodies[i].mass_kg * bodies[i].velocity_m_s;
  }
  return sum;
}

Course run_scene(const ExtremeScene& scene, const Progress& progress) {
  constexpr std::int64_t kTells = 1000;
  World world = world_of(scene);
  Course course(scene);
  StepInput input;
  input.dt_s = scene.step_s;
  FixedWork meter(scene.work_per_step);
  std::vector<MotionSeen> motions(scene.bodies.size());
  for (std::int64_t step = 0; step < scene.steps; ++step) {
    course.note(world.step(input, meter));
    for (std::size_t body = 0; body < motions.size(); ++body) {
      motions[body] = motion_of(world.models()[body], world.states()[body]);
    }
    course.look(motions);
    if (progress && step % std::max<std::int64_t>(1, scene.steps / kTells) == 0) {
      progress(static_cast<double>(step) / static_cast<double>(scene.steps));
    }
  }
  return course;
}

}  // namespace impetus::inline extremes
