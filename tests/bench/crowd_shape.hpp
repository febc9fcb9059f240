// The body that crowds are made of: one solid, with a coarse and a fine sphere-tree.
//
// It is scaled to a bounding radius of one metre about its centre of mass, so that lengths of a
// scene are in bounding radii.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "engine/dynamics/body.hpp"
#include "engine/shapes/triangle_mesh.hpp"

namespace impetus {

struct CrowdShape {
  std::string name;
  TriangleMesh mesh;  ///< about the centre of mass, farthest vertex at one metre
  MassProperties mass;
  std::shared_ptr<const VolumeTree> coarse;  ///< about 64 leaves: medial, depth 2, branching 8
  std::shared_ptr<const VolumeTree> fine;    ///< about 500 leaves: depth 3
};

inline constexpr double kSolidDensity_kg_m3 = 1000.0;

/// The mesh of the file, or the project's creature of 2,580 triangles. Throws std::exception with a
/// sentence when the file is no closed mesh.
CrowdShape crowd_shape(const std::optional<std::string>& file);

/// The shape as a body that uses `tree`.
BodyModel model_of(const CrowdShape& shape, const std::shared_ptr<const VolumeTree>& tree);

/// Nodes without children.
int leaf_count(const VolumeTree& tree);

}  // namespace impetus
