// How finely a body of a crowd is drawn: by the coarsest mesh that nobody could tell from its own.
//
//   mesh ──reduced──> level ──reduced──> level ...      each with its deviation in metres
//                       │
//    deviation, as seen from the eye, of half a pixel at most? ── yes ──> try the next
//
// Only crowds are drawn more coarsely than they are simulated: a picture of few bodies shows their
// own meshes, triangle by triangle.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "engine/shapes/triangle_mesh.hpp"

namespace impetus::inline record {

/// A picture of more bodies is a crowd's.
inline constexpr std::size_t kFewBodies = 20;

/// How far from its place the surface of one of a crowd may be drawn, on average, in pixels.
inline constexpr double kMostDeviation_px = 0.5;

/// A mesh that stands for a finer one.
struct DrawnLevel {
  std::shared_ptr<const TriangleMesh> mesh;
  /// Of either surface from the other: the root of the mean squared distance, the greater of both.
  double deviation_m{0.0};
};

/// From the finest to the coarsest, deviations rising.
using DrawnLevels = std::vector<DrawnLevel>;

[[nodiscard]] inline bool is_crowd(std::size_t bodies) { return bodies > kFewBodies; }

/// The mesh to draw of a body that has `mesh` and perhaps `coarser` ones, where a metre across the
/// line of sight takes `px_per_metre` pixels.
[[nodiscard]] const std::shared_ptr<const TriangleMesh>& mesh_as_seen(
    const std::shared_ptr<const TriangleMesh>& mesh, const DrawnLevels* coarser,
    double px_per_metre);

}  // namespace impetus::inline record
