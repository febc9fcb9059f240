// What a viewer could see of a collision: the gap between the drawn bodies, measured, not set.
//
//   eye ·························  the gap is the angle between the two closest points, so
//        ·········· p ─── q        foreshortening counts; its hidden share is the part of p–q
//                 body  body       that some drawn face covers
//
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/shapes/triangle_distance.hpp"
#include "engine/volumes/enclosure.hpp"
#include "experiments/record/staged_scene.hpp"

namespace impetus::inline run {

/// Of the bodies' own meshes and balls, in world; 0 apart when the surfaces cross.
ClosestPoints closest_surfaces(const DrawnBody& a, const Pose& pose_a, const DrawnBody& b,
                               const Pose& pose_b);

inline constexpr double kArcminPerDegree = 60.0;

/// The gap that a collision shows, which an exact one would not have.
struct CollisionTruth {
  double gap_m{0.0};         ///< closest distance of the drawn surfaces
  double gap_px{0.0};        ///< between the two closest points as projected
  double gap_arcmin{0.0};    ///< the same as a visual angle
  double hidden_share{0.0};  ///< of the gap, by sample rays; 0 where there is no gap

  /// What is left of the gap for the eye (minutes of arc).
  [[nodiscard]] double visible_arcmin() const { return gap_arcmin * (1.0 - hidden_share); }
};

/// The truth of a collision between two bodies of the scene, drawn as `looks` in these poses.
CollisionTruth measure_truth(const DrawnBody& a, const Pose& pose_a, const DrawnBody& b,
                             const Pose& pose_b, const Viewer& viewer);

/// The truth of a collision of the scene's bodies, or of one and a wall, in the states at `step`.
CollisionTruth measure_truth(const StagedScene& scene, const World& world, BodyPair bodies,
                             std::int64_t step);

/// No less than the gap_arcmin of measure_truth(), for a small share of its cost: what the gap can
/// be at most between two corners that are near each other, seen from the nearer body.
double most_gap_arcmin(const DrawnBody& a, const Pose& pose_a, const DrawnBody& b,
                       const Pose& pose_b, const Viewer& viewer);

/// The same against wall `wall` of the cube: from the point of the drawn body that is nearest to
/// the wall's plane straight to the plane. Nothing is left where the body reaches the plane or
/// beyond. Of several points equally near, the mesh's first. Walls hide nothing: those before the
/// eye are not drawn.
CollisionTruth measure_wall_truth(const DrawnBody& look, const Pose& pose, const Enclosure& walls,
                                  int wall, const Viewer& viewer);

/// The gap_arcmin of measure_wall_truth() alone, for a small share of its cost.
double wall_gap_arcmin(const DrawnBody& look, const Pose& pose, const Enclosure& walls, int wall,
                       const Viewer& viewer);

}  // namespace impetus::inline run
