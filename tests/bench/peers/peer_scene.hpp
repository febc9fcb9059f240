// A scene at an extreme in an engine that is not ours, and in ours beside it: the same bodies,
// steps and restitution.
//
// Every peer runs as its manual has it, without friction, damping and sleep; what each is and what
// it was told stands at its factory.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include "experiments/extremes/extreme_scene.hpp"

namespace impetus {

class PeerScene {
 public:
  virtual ~PeerScene() = default;
  virtual void step() = 0;
  /// By body, as the scene has them.
  [[nodiscard]] virtual std::vector<MotionSeen> motions() const = 0;
  /// Makes the body's velocity no number. Precondition: it can move.
  virtual void spoil(std::size_t body) = 0;
};

/// Precondition of all: the scene's walls, if it has any, are those of a closed cube. `scene` must
/// outlive what they return.
std::unique_ptr<PeerScene> our_scene(const ExtremeScene& scene);

/// Bullet: balls and boxes, boxes with the usual margin but at most a tenth of their thinnest half,
/// sequential impulses of ten iterations, restitution at any speed, depth taken back by split
/// impulses however small it is. The second is the same with the continuous detection that its
/// manual offers: a swept ball of .9 of the body's least half width, whenever the body moves by
/// half of that in a step.
std::unique_ptr<PeerScene> bullet_scene(const ExtremeScene& scene);
std::unique_ptr<PeerScene> continuous_bullet_scene(const ExtremeScene& scene);

/// ODE: balls and boxes, in its simple space where there are few and else in its hash space, at
/// most 16 contacts a pair, finite rotations; the quick step of twenty iterations, or the exact
/// one.
std::unique_ptr<PeerScene> ode_scene(const ExtremeScene& scene);
std::unique_ptr<PeerScene> exact_ode_scene(const ExtremeScene& scene);

/// What each library does with a mesh of no triangles at a ball's place; ours throws.
void empty_mesh_in_ours();
void empty_mesh_in_bullet();
void empty_mesh_in_ode();
void empty_mesh_in_fcl();

}  // namespace impetus
